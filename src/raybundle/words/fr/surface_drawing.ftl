surface_drawing-line_or_area = Il faut les sommets d'une ligne ou d'une zone, pas des deux.

surface_drawing-none = Rien n'est dessiné sur { $surface }.

surface_drawing-no_heights = La surface n'a pas d'altitude aux sommets de { LIST($names, most: 5) }.

surface_drawing-no_layer = Aucun dessin sur le calque { LIST($names, most: 5) }.

surface_drawing-written = { $n } { $n ->
        [one] dessin
       *[other] dessins
    } sur { LIST($layers, most: 5) }.

surface_drawing-others = { $n } { $n ->
        [one] dessin est
       *[other] dessins sont
    } sur d'autres surfaces ou calques.

surface_drawing-heights_between = Sommets sans altitude dans { LIST($names, most: 5) }.

surface_drawing-left_out = Sans altitude, laissés de côté : { LIST($names, most: 5) }.
