dropped = { PERCENT($share) } % des points image ont été rejetés avant la compensation.
