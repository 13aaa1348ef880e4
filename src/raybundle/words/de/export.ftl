export-no_csv_name = Der Name einer Punkttabelle endet auf .csv.
    .do = Einen solchen Namen wählen.

export-no_points = Kein Punkt ist von Hand gemessen; es gibt nichts zu exportieren.
    .do = Zuerst einen Punkt markieren.

export-name_not_possible = { $kind ->
        [image] Bild
       *[point] Punkt
     } { $name } lässt sich nicht in gcp_list.txt schreiben.
    .do = Eine CSV-Tabelle exportieren.

export-no_control = Kein Pass- oder Kontrollpunkt mit X, Y und Z ist markiert; es gibt nichts zu exportieren.
    .do = Zuerst einen solchen Punkt markieren.

export-not_one_file = Keine einzelne Datei: Format { LIST($formats, most: 20) }.
    .why = Mehrere Formate werden zusammen als Dateien eines Namens geschrieben.
    .do = Nur in dieses Format umwandeln.

export-same_file = Zwei der Formate { LIST($formats, most: 20) } haben denselben Dateinamen.
    .do = Nur in eines davon umwandeln.

export-format_failed = Das Format { $format } wird nicht geschrieben:

export-formats_failed = Formate, die sich nicht schreiben lassen: { $n }; geschrieben: { $written ->
        [0] keines
       *[other] { LIST($places, most: 20) }
     }.
    .do = Die folgenden Ursachen beheben, dann erneut in diese Formate umwandeln.
