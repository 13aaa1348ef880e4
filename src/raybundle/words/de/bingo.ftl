bingo-photograph_line = Eine Aufnahme beginnt mit ihrem Namen und dem ihrer Kamera.
    .do = Diese Zeile vervollständigen.

bingo-point_before_photograph = Dieser Bildpunkt gehört zu keiner Aufnahme.
    .do = Davor eine Zeile mit Aufnahme und Kamera ergänzen.
