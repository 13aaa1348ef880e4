comparison-path_taken = Eine Datei, die kein Vergleich ist, hat bereits diesen Namen.
    .do = Einen anderen Namen wählen oder die Datei löschen.
