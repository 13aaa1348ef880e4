held_not_determinable-cameras = Die Punkte bestimmen die innere Orientierung von { $ids } nicht; die Näherungswerte werden festgehalten.
    .why = Standardabweichungen gelten nur für diese Werte.
    .do = Mehr Punkte messen.
