up_ambiguous = La verticale est ambiguë : probabilité de { PERCENT($probability) } % seulement (limite { PERCENT($limit) } %).
