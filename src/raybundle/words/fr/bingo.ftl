bingo-photograph_line = Une photographie commence par son nom et celui de sa caméra.

bingo-point_before_photograph = Ce point image n'appartient à aucune photographie.
