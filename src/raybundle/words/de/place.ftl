place-line = Zeile { $line }

place-row = Datenzeile { $row }

place-column = Spalte { $column }
