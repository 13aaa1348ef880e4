static_background = Dans { $n } photographies, { PERCENT($share) } % des appariements restent aux mêmes pixels tandis que d'autres bougent.
