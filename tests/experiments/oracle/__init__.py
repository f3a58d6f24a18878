"""The oracle: a case's metrics recomputed from its replay by numpy, sharing nothing with the program's judge."""
