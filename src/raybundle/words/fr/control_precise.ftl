control_precise = Les résidus de l'appui valent { NUM($ratio, digits: 2) } fois l'annoncé, ceux de toutes les observations { NUM($sigma0, digits: 2) } fois.
