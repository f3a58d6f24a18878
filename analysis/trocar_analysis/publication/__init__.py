"""`figures`: what a result file says as a paper shows it: diagrams as SVG and PDF, LaTeX tables, captions."""
