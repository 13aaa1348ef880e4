control_leaves_open = Non déterminé par { $kind ->
        [centres] les centres de projection observés
        [both] l'appui et les centres de projection
       *[control] les points d'appui
     } : { datum-part }.

control_leaves_open-line = { $kind ->
        [centres] Les centres de projection observés
        [both] L'appui et les centres de projection
       *[control] Les points d'appui
     } sont alignés ; la rotation autour de leur droite n'est pas déterminée.

control_leaves_open-imprecise = { $kind ->
        [centres] Les centres de projection observés
        [both] L'appui et les centres de projection
       *[control] Les points d'appui
     } sont trop imprécis pour la rotation autour de leur droite.
