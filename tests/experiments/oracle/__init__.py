"""The oracle: every metric of a case recomputed with numpy from its replay, sharing nothing with the program's judge."""
