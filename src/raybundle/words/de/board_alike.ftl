board_alike = Die Kalibriertafel { $board } sieht gedreht gleich aus; ihre Punkte werden festgehalten, wie gedruckt und eben.
    .why = Ist die Kalibriertafel nicht eben, ist der Bildhauptpunkt falsch.
    .do = Eine Kalibriertafel mit gerader und ungerader Anzahl von Zeilen und Spalten verwenden.
