empirical-no_additional_parameter = { $model }: { $names } lässt sich nicht ausschließen.
    .do = { $n ->
        [0] Bei diesem Modell keinen Parameter ausschließen
       *[other] Nur { LIST($known, most: 20) } ausschließen
     }.

empirical-too_few_points = { $model }: { $object } Objekt- und { $image } Bildpunkte; nötig sind { $least } Paare.
    .why = Das Modell hat { $parameters } Parameter.
    .do = Mehr Punkte messen oder ein Modell mit weniger Parametern verwenden.

empirical-not_determined = { $model }: Diese Punkte bestimmen die { $n } Parameter nicht.
    .why = Es sind zu wenige, oder sie liegen in einer Ebene oder auf einer Geraden.
    .do = Ein Modell mit weniger Parametern verwenden oder Punkte in anderen Höhen ergänzen.

empirical-no_minimum = { $model }: kein Minimum nach { $n } Iterationen.
    .why = Die Punkte können einen groben Fehler enthalten.
    .do = Die Punkte prüfen.

empirical-unknown_model = Das empirische Modell { $name } ist unbekannt.
    .do = Eines von { LIST($known, most: 20) } verwenden.

empirical-none_fitted = Kein empirisches Modell lässt sich anpassen.
    .do = Punkte ergänzen oder ein anderes Modell verwenden.

empirical-excluded_needs_model = { OPTION("without") } braucht ein bestimmtes Modell.
    .do = { OPTION("model", "dlt-brown") } angeben.

empirical-no_redundancy = { $model } hat keine Redundanz; die Anpassung lässt sich nicht beurteilen.
    .why = Ein grober Fehler in einem Punkt verfälscht das Modell, und keine Verbesserung zeigt ihn.
    .do = Punkte ergänzen oder ein Modell mit weniger Parametern verwenden.

empirical-adequate = { $model }: Verbesserungen von { $x_px }; { $y_px } px (rms) passen zu einem Sigma von { $sigma_px } px.
    .do = Das Modell nur im Gebiet und im Höhenbereich dieser Punkte verwenden.

empirical-not_adequate = { $model } ist für diese Szene nicht geeignet: Verbesserungen von { $x_px }; { $y_px } px (rms).
    .why = Die Verbesserungen sind { $ratio }-mal so groß, wie ein Sigma von { $sigma_px } px erklärt (Grenze { $limit }).
    .do = RPC oder strenges Modell der Szene oder ein Modell mit mehr Parametern verwenden.

empirical-none_adequate = Kein Modell ist geeignet; am nächsten ist { $model }: { $left_out_px } px (rms) an ausgelassenen Koordinaten.
    .why = Das angegebene Sigma ist { $sigma_px } px.
    .do = Nach groben Fehlern suchen oder ein physikalisches Modell verwenden.

empirical-advised = { $model } ist mit { $n } Parametern geeignet: { $left_out_px } px (rms) an ausgelassenen Koordinaten.
    .do = Dieses Modell nur im Gebiet und im Höhenbereich der Punkte verwenden.
