folder-exists = Den Ordner gibt es schon, und er ist nicht leer.
    .do = Einen anderen Ordner wählen oder diesen löschen.

folder-url = Der Pfad beginnt wie eine URL ({ $scheme }//).
    .why = Ergebnisse werden in Ordner dieses Rechners geschrieben.
    .do = In einen Ordner schreiben und ihn dorthin kopieren. { OPTION("store", "URL") } hält Produkte von orient und surface in einem Bucket.

folder-parent_is_a_file = { $parent } ist kein Ordner; darin kann nichts geschrieben werden.
    .do = Einen anderen Pfad wählen.

folder-special_file = Das ist weder eine Datei noch ein Ordner.
    .do = Einen anderen Namen wählen.

folder-is_a_file = Unter diesem Namen gibt es eine Datei; nötig ist ein Ordner.
    .do = Einen anderen Namen wählen.

folder-file_missing = Der Ordner hat keine Datei { $name }.
    .do = Prüfen, ob es der richtige Ordner ist.

folder-several_files = Der Ordner hat { $n } Dateien { $name }; nötig ist eine.
    .do = Die übrigen anderswohin verschieben.

folder-not_listed = Der Inhalt des Ordners ist nicht lesbar ({ $detail }).
    .do = Die Zugriffsrechte prüfen.

folder-missing = Den Ordner dieser Datei gibt es nicht.
    .do = Den Ordner zuerst anlegen.

folder-other_block = Der Ordner enthält einen anderen Block; er wird nicht überschrieben.
    .do = { OPTION("out") } anders wählen.

folder-missing_itself = Diesen Ordner gibt es nicht.
    .do = Den Pfad prüfen.
