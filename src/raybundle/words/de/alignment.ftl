alignment-too_few_points = { $kind } { $name }: { $n } Punkte an verschiedenen Orten; { $least } sind nötig.
    .do = Gemessene Punkte ergänzen oder die Zeilen in { $table }.csv löschen.
