relief_unknown = Verknüpfungspunkte haben keine Werte in den Spalten { $columns }.
    .why = Die Standardabweichungen dieser Punkte enthalten das Relief innerhalb der Zuordnungsfenster nicht.
    .do = points.csv mit allen Spalten verwenden oder die Aufnahmen neu orientieren.

relief_unknown-quick = Standardabweichungen der Verknüpfungspunkte enthalten das Relief des Objekts nicht ({ OPTION("precise", "False", flag: "quick") }).
    .why = Auf rauem Boden und in Bewuchs sind Fehler bis zu dreimal so groß, und einer von fünf übersteigt fünf Standardabweichungen.
    .do = Für Werte, die abgegeben werden, ohne diese Option orientieren.
