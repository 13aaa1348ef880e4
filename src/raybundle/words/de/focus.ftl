focus-calibrations_differ = Die Kalibrierungen bei zwei Fokussierungen haben verschiedene Modelle oder freie Parameter.
    .do = Beide mit demselben Modell und denselben Parametern kalibrieren.

focus-out_of_range = Die Fokussierung auf { $focus_m } m liegt außerhalb der kalibrierten { $near_m } bis { $far_m } m.
    .do = Bei dieser Fokussierung kalibrieren.
