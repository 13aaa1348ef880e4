relief_unknown = Verknüpfungspunkte haben keine Werte in den Spalten { $columns }.
    .why = Die Standardabweichungen dieser Punkte enthalten das Relief innerhalb der Zuordnungsfenster nicht.
    .do = points.csv mit allen Spalten verwenden oder die Aufnahmen neu orientieren.
