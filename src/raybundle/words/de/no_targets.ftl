no_targets = Mit natürlichen Punkten kalibriert: { $n } geprüfte Aufnahmen zeigen weder codierte Zielmarken noch eine Kalibriertafel.
    .why = Natürliche Punkte sind um ein Mehrfaches ungenauer. Geprüft: { $names }.
    .do = Andere Aufnahmen mit Zielmarken in einen eigenen Ordner legen und die Zielmarken nennen: { OPTION("target", "chessboard-12x9") }.

no_targets-few = Mit natürlichen Punkten kalibriert: Weniger als die Hälfte von { $n } geprüften Aufnahmen zeigt Zielmarken ({ $families }).
    .why = Natürliche Punkte sind um ein Mehrfaches ungenauer. Geprüft: { $names }.
    .do = Die Aufnahmen von Zielmarken in einen eigenen Ordner legen oder die Zielmarken nennen: { OPTION("target", $first) }.

no_targets-unread = In keiner Aufnahme wurde eine Zielmarke von { $families } gelesen.
    .do = Den Namen der Markenfamilie und die Größe der Zielmarken in den Bildern prüfen.
