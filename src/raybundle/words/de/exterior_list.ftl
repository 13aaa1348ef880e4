exterior_list-touching = Zwei Zahlen berühren sich: { $value }.
    .why = Keine Zeile der Datei trennt sie durch ein Leerzeichen.
    .do = Die Liste mit breiteren Spalten oder mit Semikolons schreiben.

exterior_list-columns = Eine Zeile ohne Spaltennamen hat { $n } Spalten; verstanden werden { LIST($needed) }.
    .do = Eine erste Zeile mit Namen ergänzen, etwa name X Y Z omega phi kappa.

exterior_list-angle_size = { $value } ist kein Winkel in Grad, Gon oder Radiant (größter: { $largest }).
    .do = Die Zahl oder die Spaltennamen berichtigen.
