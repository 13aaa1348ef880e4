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
