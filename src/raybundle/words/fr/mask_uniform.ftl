mask_uniform = Les masques de { $n } photographies ne cachent rien : { LIST($ids, most: 3) }.

mask_uniform-hidden = { $n } photographies sont entièrement cachées par leurs masques : { LIST($ids, most: 3) }.
