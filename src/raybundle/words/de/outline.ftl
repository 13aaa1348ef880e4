outline-crosses_itself = { $name } schneidet sich selbst bei den Seiten ab den Ecken { $first } und { $second }.
    .do = Die Ecken in ihrer Folge entlang des Umrisses angeben.

outline-no_area = { $name } umschließt keine Fläche.
    .do = Mindestens drei Ecken angeben, die nicht auf einer Geraden liegen.

outline-not_one = Die Datei hat { $n } Linien und Flächen; nötig ist genau eine.
    .do = Eine Datei mit einer Linie oder Fläche angeben.

outline-no_pair = { $text } ist kein Zahlenpaar.
    .do = In jede Zeile X und Y schreiben.

outline-empty = Die Datei enthält keine Koordinaten.
    .do = In jede Zeile X und Y schreiben.

outline-no_cell = Der Umriss enthält keine Zelle der Oberfläche.
    .do = Seine Koordinaten und deren System prüfen.

outline-too_few_heights = { $n } von { $total } Stellen entlang des Umrisses haben eine Höhe; zu wenige für eine Ebene.
    .do = Die Höhe der Bezugsfläche angeben.

outline-overlap = Zwei der Umrisse überlappen sich.
    .do = Getrennte Gebiete angeben oder einen Umriss um alle.

outline-beyond_heights = { PERCENT($share, digits: 3) } % des Umrisses liegen außerhalb des Höhenrasters (Grenze { PERCENT($limit) } %).
    .why = Das Raster reicht über { NUM($left, digits: 8) } { NUM($bottom, digits: 8) } { NUM($right, digits: 8) } { NUM($top, digits: 8) }.
    .do = Einen Umriss innerhalb des Rasters angeben.

outline-extent_empty = Die Ausdehnung { NUM($left, digits: 8) } { NUM($bottom, digits: 8) } { NUM($right, digits: 8) } { NUM($top, digits: 8) } ist leer.
    .do = Links, unten, rechts und oben in dieser Folge angeben.

outline-option_empty = { OPTION($name) } ist leer.
    .do = Eine Datei oder Ecken als X Y, X Y, ... angeben.

outline-neither_file_nor_corners = { OPTION($name, $given) } ist weder eine Datei noch eine Liste von Ecken.
    .do = Ecken als X Y, X Y, ... schreiben: Leerzeichen zwischen den Zahlen, Komma zwischen den Ecken.

outline-no_area_in_file = Die Datei hat keine Fläche; Linien und Punkte umschließen nichts.
    .do = Eine Datei mit einem Polygon angeben.

outline-too_few_corners = { OPTION($name, $given) } hat weniger als drei Ecken.
    .do = Mindestens drei Ecken X Y, X Y, X Y angeben.

outline-no_line_in_file = Die Datei hat keine Linie.
    .do = Eine Datei mit einer Linie angeben.

outline-single_place = { OPTION($name, $given) } ist ein einzelner Ort; eine Linie benötigt zwei.
    .do = Zwei oder mehr Punkte angeben.

outline-line_without_length = Linie { $given }: Zwei aufeinanderfolgende Orte sind gleich, oder sie hat nur einen.
    .do = Aufeinanderfolgende Orte angeben, die verschieden sind.

outline-heights_in_no_map = Die Datei ist in { $system }; diese Höhen liegen auf einer Ebene des Objekts, nicht in Landeskoordinaten.
    .do = Koordinaten der Ebene als CSV oder GeoJSON ohne Koordinatensystem angeben.

outline-hole_outside = Loch { $hole } des Umrisses verlässt den Rand bei { NUM($x, digits: 8) }, { NUM($y, digits: 8) }.
    .why = Die umschlossene Fläche ist mehrdeutig.
    .do = Eine Fläche angeben, bei der alle Löcher innerhalb des Randes liegen.

outline-holes_overlap = Die Löcher { $other } und { $hole } des Umrisses überlappen sich bei { NUM($x, digits: 8) }, { NUM($y, digits: 8) }.
    .why = Die umschlossene Fläche ist mehrdeutig.
    .do = Eine Fläche mit getrennten Löchern angeben.

outline-only_holes = Die Löcher des Umrisses bedecken ihn ganz (bei { NUM($x, digits: 8) }, { NUM($y, digits: 8) }).
    .do = Eine Fläche mit kleineren Löchern angeben.
