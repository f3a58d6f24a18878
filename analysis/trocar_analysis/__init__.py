"""Reads Trocar's result files: tables for the terminal, pictures of what a strategy did."""
