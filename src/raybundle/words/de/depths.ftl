depths-small_angle = Ihre Strahlen schneiden sich unter { NUM($angle_deg, digits: 2) }° (Median); { $least_deg }° sind nötig.
    .why = Die Basis ist zu kurz oder liegt in der Blickrichtung.

depths-scales_differ = Ihre Maßstäbe unterscheiden sich um den Faktor { NUM($ratio, digits: 2) } (Grenze { $limit }).

depths-no_common_points = Keine zwei Aufnahmen haben genügend gemeinsame Punkte.

depths-no_partner = Keine andere Aufnahme hat genügend gemeinsame Punkte mit ihr.

depths-no_useful_partner = Keine andere Aufnahme bildet mit ihr ein brauchbares Paar.

depths-region_not_shown = Sie zeigt das Gebiet nicht.
