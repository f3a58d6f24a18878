"""`figure`: pictures of steps side by side, described by a file, as the paper's figures are."""
