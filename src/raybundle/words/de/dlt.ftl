dlt-too_few_points = { $n } Punkte sind gegeben; eine DLT braucht sechs, die nicht in einer Ebene liegen.
    .do = Mehr Punkte messen.

dlt-plane = Die Punkte liegen in einer Ebene (Tiefe { NUM($ratio, digits: 2) } ihrer Ausdehnung).
    .why = Eine DLT braucht Tiefe.
    .do = Punkte vor oder hinter der Ebene messen.

dlt-behind = Die DLT legt die Punkte hinter die Kamera.
    .why = Das Bild ist gespiegelt, oder y zählt nach unten.
    .do = Die Richtung der Bildachsen korrigieren.
