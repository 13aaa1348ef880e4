pixels-shape = Les pixels doivent être un tableau de forme (n, 2), pas ({ $shape }).

pixels-distance = La distance { $distance } n'est pas supérieure à 0.
