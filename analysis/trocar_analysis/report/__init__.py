"""`report`: one HTML file that shows a sweep, from the overview down to a vertex of a step."""
