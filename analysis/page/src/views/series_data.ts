// Which series of which cases the report holds.

export interface SeriesIndex {}
