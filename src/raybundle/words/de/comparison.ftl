comparison-path_taken = Eine Datei, die kein Vergleich ist, hat bereits diesen Namen.
    .do = Einen anderen Namen wählen oder die Datei löschen.

comparison-one_result = Es gibt kein früheres Ergebnis zum Vergleich.
    .do = Zwei Ergebnisordner angeben.
