"""The report on paper: what the typesetter is given, and the PDF that it makes."""
