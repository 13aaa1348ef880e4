depths-small_angle = Die Strahlen dieser Aufnahmen schneiden sich unter { NUM($angle_deg, digits: 2) }° (Median); { $least_deg }° sind nötig.
    .why = Die Basis ist zu kurz oder liegt in der Blickrichtung.
    .do = Von weiter auseinanderliegenden Standpunkten aufnehmen.

depths-scales_differ = Die Bildmaßstäbe dieser Aufnahmen unterscheiden sich um den Faktor { NUM($ratio, digits: 2) } (Grenze { $limit }).
    .do = Aus ähnlichen Entfernungen aufnehmen.

depths-no_common_points = Keine zwei Aufnahmen haben genügend gemeinsame Punkte.

depths-no_partner = Keine andere Aufnahme hat genügend gemeinsame Punkte mit dieser Aufnahme.

depths-no_useful_partner = Keine andere Aufnahme bildet mit dieser Aufnahme ein brauchbares Paar.

depths-region_not_shown = Die Aufnahme zeigt das Gebiet nicht.
