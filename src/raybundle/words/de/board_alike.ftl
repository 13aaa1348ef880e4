board_alike = Die Tafel { $board } sieht gedreht gleich aus; ihre Punkte werden festgehalten, wie gedruckt und eben.
    .why = Ist die Tafel nicht eben, ist der Hauptpunkt falsch.
    .do = Eine Tafel mit gerader und ungerader Anzahl von Zeilen und Spalten verwenden.
