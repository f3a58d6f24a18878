"""The paper's claims (experiments/claims.toml), judged on a result file."""
