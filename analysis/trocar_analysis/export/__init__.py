"""`export`: a recorded case as meshes for other programs."""
