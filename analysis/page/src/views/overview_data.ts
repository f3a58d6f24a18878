// What Python has worked out for the overview.

export interface Overview {}
