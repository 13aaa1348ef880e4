contour-too_many_levels = Die Höhen umfassen { $n } Höhenlinienstufen; höchstens { $most } werden gezeichnet.
    .do = Einen größeren Abstand wählen.
