data=
{
	"config" : 
	{
		"center_latitude" : 52.3,
		"compute_type" : 0,
		"coord_cov_file" : "",
		"files_unit" : 1,
		"local_center" : [ 0.0, 0.0, 0.0 ],
		"name" : "traverse",
		"refraction" : 0.12,
		"root_COR_file" : "traverse.cor",
		"root_OBS_file" : "elsewhere.obs",
		"use_proj" : false
	}
}
