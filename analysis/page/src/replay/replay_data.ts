// A recorded case as the report holds it.

export interface Replay {
  caseId: string;
}
