place-line = ligne { $line }

place-row = rangée { $row }

place-column = colonne { $column }
