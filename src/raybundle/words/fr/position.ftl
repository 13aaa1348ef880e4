position-beyond_degrees = { NUM($value, digits: 10) }° est hors de ± { $limit }°.
