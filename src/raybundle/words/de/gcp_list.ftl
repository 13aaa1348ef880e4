gcp_list-empty = Die Datei ist leer.
    .do = In die erste Zeile das Koordinatensystem schreiben, dann Zeilen X Y Z x y image.

gcp_list-no_system = Die erste Zeile nennt kein Koordinatensystem.
    .do = Dort EPSG:CODE, WGS84 UTM 11N oder einen PROJ-Text schreiben; eine Tabelle mit Spaltennamen ist eine .csv-Datei.

gcp_list-no_point = Nach der ersten Zeile folgt kein Punkt.
    .do = Zeilen X Y Z x y image ergänzen.

gcp_list-name_missing = Diese Zeile hat keinen Punktnamen, andere aber haben einen.
    .do = Allen Zeilen einen Namen geben oder keiner.

gcp_list-coordinates_differ = Punkt { $point } hat in Zeile { $earlier } andere Koordinaten.
    .do = Eine der beiden Zeilen korrigieren{ $blanks ->
        [yes] { " " }oder Spalten durch Tabulatoren trennen: Als Bild wurde { $image } gelesen
       *[no] { "" }
     }.

gcp_list-too_few_columns = Die Zeile hat { $n } Spalten: { $text }.
    .do = { LIST($needed, most: 8) } und bei Bedarf einen Namen angeben.

gcp_list-crs_missing = Eine gcp_list.txt braucht das Koordinatensystem ihrer Punkte.
    .do = { OPTION("crs", "EPSG:32633") } angeben; auch ein PROJ-String oder WGS84 UTM 33N ist möglich.
