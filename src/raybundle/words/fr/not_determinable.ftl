not_determinable = Caméra { $name } : { $symbol } n'est pas déterminable (écart-type { NUM($sigma, digits: 2) } { $unit }).
