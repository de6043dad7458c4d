struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_12 {
member: type_2,
member_1: u32,
member_2: type_5,
member_3: type_7,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_5,
member_8: f32,
member_9: f32,
}
struct type_13 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: type_2,
member_5: u32,
member_6: type_4,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: type_5,
member_11: f32,
member_12: f32,
member_13: f32,
member_14: type_5,
member_15: type_5,
member_16: type_6,
member_17: type_5,
member_18: type_9,
member_19: type_11,
member_20: type_5,
member_21: type_12,
}
struct type_14 {
member: type_13,
}
struct type_16 {
member: array<f32>,
}
struct type_20 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: vec3<f32>,
member_13: i32,
member_14: i32,
member_15: f32,
}
struct type_23 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(2)
var<storage> global_3: type_16;
@group(0) @binding(3)
var<storage> global_4: type_16;
@group(0) @binding(4)
var<storage, read_write> global_5: type_16;
@group(0) @binding(5)
var<storage, read_write> global_6: type_23;
fn function_() {
var phi_700_: u32;
var phi_783_: i32;
var phi_785_: type_20;
var phi_788_: i32;
var phi_790_: i32;
var phi_2064_: i32;
var phi_2067_: i32;
var phi_2065_: i32;
var phi_2068_: i32;
var phi_3179_: i32;
var phi_3181_: i32;
var phi_3184_: i32;
var phi_3182_: i32;
var phi_3185_: i32;
var local: i32;
var local_1: i32;
var phi_3486_: type_20;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var phi_3827_: type_20;
var phi_4158_: type_20;
var phi_4211_: type_20;
var phi_4225_: type_20;
var local_8: i32;
var local_9: i32;
var phi_4670_: type_20;
var phi_4671_: type_20;
var phi_4651_: type_20;
var phi_4672_: type_20;
var phi_4677_: type_20;
var phi_4678_: type_20;
var phi_4679_: bool;
var phi_4683_: type_20;
var local_10: i32;
var local_11: i32;
var phi_3159_: type_20;
var phi_4685_: type_20;
var phi_4686_: i32;
var phi_1454_: i32;
var phi_1457_: i32;
var phi_1455_: i32;
var phi_1458_: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var phi_2060_: type_20;
var phi_1774_: type_20;
var phi_2062_: type_20;
var phi_4687_: type_20;
var phi_4688_: i32;
var phi_1413_: type_20;
var phi_1414_: type_20;
var phi_1446_: i32;
var phi_4689_: type_20;
var phi_4690_: i32;
var phi_786_: type_20;
var phi_789_: i32;
var phi_791_: i32;
var local_15: i32;
var local_16: i32;
var phi_4696_: i32;
var local_17: type_20;
var local_18: type_20;
var local_19: type_20;
var local_20: type_20;
var local_21: type_20;
var local_22: type_20;
var local_23: type_20;
var local_24: type_20;
var local_25: type_20;
var local_26: type_20;
var local_27: type_20;
var local_28: type_20;
var local_29: type_20;
var local_30: type_20;
var local_31: type_20;
var local_32: type_20;
var local_33: type_20;
var local_34: type_20;
var local_35: type_20;
var local_36: type_20;
var local_37: type_20;
var local_38: type_20;
var local_39: type_20;
var local_40: type_20;
var local_41: type_20;
var local_42: type_20;
var local_43: f32;
let _e97 = global;
let _e101 = arrayLength((&global_3.member));
let _e103 = arrayLength((&global_4.member));
let _e110 = global_1.member.member;
if (_e97.x < _e110.member) {
if (_e97.y < _e110.member_1) {
let _e117 = (_e110.member * _e110.member_1);
let _e119 = ((_e97.y * _e110.member) + _e97.x);
let _e120 = bitcast<i32>(_e119);
let _e122 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e124 = select(_e122, _e120, (_e120 < _e122));
let _e130 = global_5.member[bitcast<u32>(select(0i, _e124, (_e124 > 0i)))];
let _e131 = (_e117 + _e119);
let _e132 = bitcast<i32>(_e131);
let _e134 = select(_e122, _e132, (_e132 < _e122));
let _e140 = global_5.member[bitcast<u32>(select(0i, _e134, (_e134 > 0i)))];
let _e142 = ((2u * _e117) + _e119);
let _e143 = bitcast<i32>(_e142);
let _e145 = select(_e122, _e143, (_e143 < _e122));
let _e151 = global_5.member[bitcast<u32>(select(0i, _e145, (_e145 > 0i)))];
let _e153 = ((3u * _e117) + _e119);
let _e154 = bitcast<i32>(_e153);
let _e156 = select(_e122, _e154, (_e154 < _e122));
let _e162 = global_5.member[bitcast<u32>(select(0i, _e156, (_e156 > 0i)))];
let _e164 = ((4u * _e117) + _e119);
let _e165 = bitcast<i32>(_e164);
let _e167 = select(_e122, _e165, (_e165 < _e122));
let _e173 = global_5.member[bitcast<u32>(select(0i, _e167, (_e167 > 0i)))];
let _e175 = ((5u * _e117) + _e119);
let _e176 = bitcast<i32>(_e175);
let _e178 = select(_e122, _e176, (_e176 < _e122));
let _e184 = global_5.member[bitcast<u32>(select(0i, _e178, (_e178 > 0i)))];
let _e186 = ((6u * _e117) + _e119);
let _e187 = bitcast<i32>(_e186);
let _e189 = select(_e122, _e187, (_e187 < _e122));
let _e195 = global_5.member[bitcast<u32>(select(0i, _e189, (_e189 > 0i)))];
let _e197 = ((7u * _e117) + _e119);
let _e198 = bitcast<i32>(_e197);
let _e200 = select(_e122, _e198, (_e198 < _e122));
let _e206 = global_5.member[bitcast<u32>(select(0i, _e200, (_e200 > 0i)))];
let _e208 = ((8u * _e117) + _e119);
let _e209 = bitcast<i32>(_e208);
let _e211 = select(_e122, _e209, (_e209 < _e122));
let _e217 = global_5.member[bitcast<u32>(select(0i, _e211, (_e211 > 0i)))];
let _e219 = ((9u * _e117) + _e119);
let _e220 = bitcast<i32>(_e219);
let _e222 = select(_e122, _e220, (_e220 < _e122));
let _e228 = global_5.member[bitcast<u32>(select(0i, _e222, (_e222 > 0i)))];
let _e230 = ((10u * _e117) + _e119);
let _e231 = bitcast<i32>(_e230);
let _e233 = select(_e122, _e231, (_e231 < _e122));
let _e239 = global_5.member[bitcast<u32>(select(0i, _e233, (_e233 > 0i)))];
let _e241 = ((11u * _e117) + _e119);
let _e242 = bitcast<i32>(_e241);
let _e244 = select(_e122, _e242, (_e242 < _e122));
let _e250 = global_5.member[bitcast<u32>(select(0i, _e244, (_e244 > 0i)))];
let _e252 = ((12u * _e117) + _e119);
let _e253 = bitcast<i32>(_e252);
let _e255 = select(_e122, _e253, (_e253 < _e122));
let _e261 = global_5.member[bitcast<u32>(select(0i, _e255, (_e255 > 0i)))];
let _e263 = ((13u * _e117) + _e119);
let _e264 = bitcast<i32>(_e263);
let _e266 = select(_e122, _e264, (_e264 < _e122));
let _e272 = global_5.member[bitcast<u32>(select(0i, _e266, (_e266 > 0i)))];
let _e274 = ((14u * _e117) + _e119);
let _e275 = bitcast<i32>(_e274);
let _e277 = select(_e122, _e275, (_e275 < _e122));
let _e283 = global_5.member[bitcast<u32>(select(0i, _e277, (_e277 > 0i)))];
let _e285 = ((15u * _e117) + _e119);
let _e286 = bitcast<i32>(_e285);
let _e288 = select(_e122, _e286, (_e286 < _e122));
let _e294 = global_5.member[bitcast<u32>(select(0i, _e288, (_e288 > 0i)))];
let _e296 = ((16u * _e117) + _e119);
let _e297 = bitcast<i32>(_e296);
let _e299 = select(_e122, _e297, (_e297 < _e122));
let _e305 = global_5.member[bitcast<u32>(select(0i, _e299, (_e299 > 0i)))];
let _e307 = ((17u * _e117) + _e119);
let _e308 = bitcast<i32>(_e307);
let _e310 = select(_e122, _e308, (_e308 < _e122));
let _e316 = global_5.member[bitcast<u32>(select(0i, _e310, (_e310 > 0i)))];
let _e318 = ((18u * _e117) + _e119);
let _e319 = bitcast<i32>(_e318);
let _e321 = select(_e122, _e319, (_e319 < _e122));
let _e327 = global_5.member[bitcast<u32>(select(0i, _e321, (_e321 > 0i)))];
let _e329 = ((19u * _e117) + _e119);
let _e330 = bitcast<i32>(_e329);
let _e332 = select(_e122, _e330, (_e330 < _e122));
let _e338 = global_5.member[bitcast<u32>(select(0i, _e332, (_e332 > 0i)))];
let _e340 = ((20u * _e117) + _e119);
let _e341 = bitcast<i32>(_e340);
let _e343 = select(_e122, _e341, (_e341 < _e122));
let _e349 = global_5.member[bitcast<u32>(select(0i, _e343, (_e343 > 0i)))];
let _e351 = ((21u * _e117) + _e119);
let _e352 = bitcast<i32>(_e351);
let _e354 = select(_e122, _e352, (_e352 < _e122));
let _e360 = global_5.member[bitcast<u32>(select(0i, _e354, (_e354 > 0i)))];
let _e362 = ((22u * _e117) + _e119);
let _e363 = bitcast<i32>(_e362);
let _e365 = select(_e122, _e363, (_e363 < _e122));
let _e371 = global_5.member[bitcast<u32>(select(0i, _e365, (_e365 > 0i)))];
let _e373 = ((23u * _e117) + _e119);
let _e374 = bitcast<i32>(_e373);
let _e376 = select(_e122, _e374, (_e374 < _e122));
let _e382 = global_5.member[bitcast<u32>(select(0i, _e376, (_e376 > 0i)))];
let _e384 = ((24u * _e117) + _e119);
let _e385 = bitcast<i32>(_e384);
let _e387 = select(_e122, _e385, (_e385 < _e122));
let _e393 = global_5.member[bitcast<u32>(select(0i, _e387, (_e387 > 0i)))];
let _e395 = ((25u * _e117) + _e119);
let _e396 = bitcast<i32>(_e395);
let _e398 = select(_e122, _e396, (_e396 < _e122));
let _e404 = global_5.member[bitcast<u32>(select(0i, _e398, (_e398 > 0i)))];
let _e406 = ((26u * _e117) + _e119);
let _e407 = bitcast<i32>(_e406);
let _e409 = select(_e122, _e407, (_e407 < _e122));
let _e415 = global_5.member[bitcast<u32>(select(0i, _e409, (_e409 > 0i)))];
let _e417 = ((27u * _e117) + _e119);
let _e418 = bitcast<i32>(_e417);
let _e420 = select(_e122, _e418, (_e418 < _e122));
let _e426 = global_5.member[bitcast<u32>(select(0i, _e420, (_e420 > 0i)))];
if (_e305 == 0f) {
phi_700_ = 3u;
} else {
phi_700_ = select(0u, 1u, (_e305 == 4f));
}
let _e431 = phi_700_;
if (_e431 > 0u) {
if (arrayLength((&global_6.member)) >= 3u) {
let _e440 = atomicLoad((&global_6.member[0u]));
if (_e440 == 0u) {
atomicStore((&global_6.member[0u]), ((_e110.member + 7u) / 8u));
atomicStore((&global_6.member[1u]), ((_e110.member_1 + 7u) / 8u));
atomicStore((&global_6.member[2u]), 1u);
}
}
}
if (_e431 > 1u) {
let _e459 = select(0i, select(select(i32(_e316), i32(-2147483648), (_e316 < -2147483600f)), 2147483647i, (_e316 > 2147483500f)), (_e316 == _e316));
let _e476 = bitcast<i32>(arrayLength((&global_2.member)));
if (_e459 == 16i) {
phi_783_ = 0i;
} else {
phi_783_ = -(_e459);
}
let _e481 = phi_783_;
phi_785_ = type_20(vec3<f32>(_e130, _e140, _e151), vec3<f32>(_e162, _e173, _e184), vec3<f32>(_e195, _e206, _e217), vec3<f32>(_e228, _e239, _e250), vec3<f32>(_e261, _e272, _e283), _e294, _e305, _e459, _e327, _e338, _e349, _e360, vec3<f32>(_e371, _e382, _e393), select(0i, select(select(i32(_e404), i32(-2147483648), (_e404 < -2147483600f)), 2147483647i, (_e404 > 2147483500f)), (_e404 == _e404)), select(0i, select(select(i32(_e415), i32(-2147483648), (_e415 < -2147483600f)), 2147483647i, (_e415 > 2147483500f)), (_e415 == _e415)), _e426);
phi_788_ = 0i;
phi_790_ = _e481;
loop {
let _e483 = phi_785_;
let _e485 = phi_788_;
let _e487 = phi_790_;
local_15 = _e487;
local_16 = _e487;
local_17 = _e483;
local_18 = _e483;
local_19 = _e483;
local_20 = _e483;
local_21 = _e483;
local_22 = _e483;
local_23 = _e483;
local_24 = _e483;
local_25 = _e483;
local_26 = _e483;
local_27 = _e483;
local_28 = _e483;
local_29 = _e483;
local_30 = _e483;
local_31 = _e483;
local_32 = _e483;
local_33 = _e483;
local_34 = _e483;
local_35 = _e483;
local_36 = _e483;
local_37 = _e483;
local_38 = _e483;
local_39 = _e483;
local_40 = _e483;
local_41 = _e483;
local_42 = _e483;
let _e491 = ((_e485 < 1024i) && (_e483.member_6 == 0f));
local_43 = _e483.member_6;
if _e491 {
if (_e483.member_13 < (_e476 / 8i)) {
let _e2993 = (_e483.member_13 * 8i);
let _e2997 = bitcast<f32>((bitcast<u32>(_e483.member_1.x) & 2147483647u));
let _e3002 = (1f / select(_e483.member_1.x, select(1e-12f, -1e-12f, (_e483.member_1.x < 0f)), (_e2997 < 1e-12f)));
let _e3006 = bitcast<f32>((bitcast<u32>(_e483.member_1.y) & 2147483647u));
let _e3011 = (1f / select(_e483.member_1.y, select(1e-12f, -1e-12f, (_e483.member_1.y < 0f)), (_e3006 < 1e-12f)));
let _e3015 = bitcast<f32>((bitcast<u32>(_e483.member_1.z) & 2147483647u));
let _e3020 = (1f / select(_e483.member_1.z, select(1e-12f, -1e-12f, (_e483.member_1.z < 0f)), (_e3015 < 1e-12f)));
let _e3022 = (_e476 - 1i);
let _e3024 = select(_e3022, _e2993, (_e2993 < _e3022));
let _e3030 = global_2.member[bitcast<u32>(select(0i, _e3024, (_e3024 > 0i)))];
let _e3031 = (_e2993 + 1i);
let _e3033 = select(_e3022, _e3031, (_e3031 < _e3022));
let _e3039 = global_2.member[bitcast<u32>(select(0i, _e3033, (_e3033 > 0i)))];
let _e3040 = (_e2993 + 2i);
let _e3042 = select(_e3022, _e3040, (_e3040 < _e3022));
let _e3048 = global_2.member[bitcast<u32>(select(0i, _e3042, (_e3042 > 0i)))];
let _e3049 = (_e2993 + 3i);
let _e3051 = select(_e3022, _e3049, (_e3049 < _e3022));
let _e3057 = global_2.member[bitcast<u32>(select(0i, _e3051, (_e3051 > 0i)))];
let _e3058 = (_e2993 + 4i);
let _e3060 = select(_e3022, _e3058, (_e3058 < _e3022));
let _e3066 = global_2.member[bitcast<u32>(select(0i, _e3060, (_e3060 > 0i)))];
let _e3067 = (_e2993 + 5i);
let _e3069 = select(_e3022, _e3067, (_e3067 < _e3022));
let _e3075 = global_2.member[bitcast<u32>(select(0i, _e3069, (_e3069 > 0i)))];
let _e3078 = ((_e3030 - _e483.member.x) * _e3002);
let _e3080 = ((_e3057 - _e483.member.x) * _e3002);
let _e3083 = ((_e3039 - _e483.member.y) * _e3011);
let _e3085 = ((_e3066 - _e483.member.y) * _e3011);
let _e3088 = ((_e3048 - _e483.member.z) * _e3020);
let _e3090 = ((_e3075 - _e483.member.z) * _e3020);
let _e3092 = select(_e3080, _e3078, (_e3078 < _e3080));
let _e3094 = select(_e3085, _e3083, (_e3083 < _e3085));
let _e3096 = select(_e3094, _e3092, (_e3092 > _e3094));
let _e3098 = select(_e3090, _e3088, (_e3088 < _e3090));
let _e3102 = select(_e3080, _e3078, (_e3078 > _e3080));
let _e3104 = select(_e3085, _e3083, (_e3083 > _e3085));
let _e3106 = select(_e3104, _e3102, (_e3102 < _e3104));
let _e3108 = select(_e3090, _e3088, (_e3088 > _e3090));
let _e3110 = select(_e3108, _e3106, (_e3106 < _e3108));
let _e3116 = ((select(_e3098, _e3096, (_e3096 > _e3098)) <= select(_e483.member_15, _e3110, (_e3110 < _e483.member_15))) && (_e3110 >= 0f));
let _e3117 = (_e2993 + 6i);
let _e3119 = select(_e3022, _e3117, (_e3117 < _e3022));
let _e3125 = global_2.member[bitcast<u32>(select(0i, _e3119, (_e3119 > 0i)))];
let _e3132 = select(0i, select(select(i32(_e3125), i32(-2147483648), (_e3125 < -2147483600f)), 2147483647i, (_e3125 > 2147483500f)), (_e3125 == _e3125));
if (_e3116 && (_e3132 >= 0i)) {
let _e3137 = ((_e2997 >= _e3006) && (_e2997 >= _e3015));
let _e3140 = (!(_e3137) && (_e3006 >= _e3015));
let _e3147 = (1f / select(select(_e483.member_1.z, _e483.member_1.y, _e3140), _e483.member_1.x, _e3137));
let _e3148 = (select(select(_e483.member_1.x, _e483.member_1.z, _e3140), _e483.member_1.y, _e3137) * _e3147);
let _e3149 = (select(select(_e483.member_1.y, _e483.member_1.x, _e3140), _e483.member_1.z, _e3137) * _e3147);
let _e3150 = (_e3132 * 19i);
let _e3152 = (bitcast<i32>(_e101) - 1i);
let _e3154 = select(_e3152, _e3150, (_e3150 < _e3152));
let _e3160 = global_3.member[bitcast<u32>(select(0i, _e3154, (_e3154 > 0i)))];
let _e3161 = (_e3150 + 1i);
let _e3163 = select(_e3152, _e3161, (_e3161 < _e3152));
let _e3169 = global_3.member[bitcast<u32>(select(0i, _e3163, (_e3163 > 0i)))];
let _e3170 = (_e3150 + 2i);
let _e3172 = select(_e3152, _e3170, (_e3170 < _e3152));
let _e3178 = global_3.member[bitcast<u32>(select(0i, _e3172, (_e3172 > 0i)))];
let _e3179 = (_e3160 - _e483.member.x);
let _e3180 = (_e3169 - _e483.member.y);
let _e3181 = (_e3178 - _e483.member.z);
let _e3187 = select(select(_e3181, _e3180, _e3140), _e3179, _e3137);
let _e3189 = (select(select(_e3179, _e3181, _e3140), _e3180, _e3137) - (_e3148 * _e3187));
let _e3191 = (select(select(_e3180, _e3179, _e3140), _e3181, _e3137) - (_e3149 * _e3187));
let _e3193 = (_e3150 + 3i);
let _e3195 = select(_e3152, _e3193, (_e3193 < _e3152));
let _e3201 = global_3.member[bitcast<u32>(select(0i, _e3195, (_e3195 > 0i)))];
let _e3202 = (_e3150 + 4i);
let _e3204 = select(_e3152, _e3202, (_e3202 < _e3152));
let _e3210 = global_3.member[bitcast<u32>(select(0i, _e3204, (_e3204 > 0i)))];
let _e3211 = (_e3150 + 5i);
let _e3213 = select(_e3152, _e3211, (_e3211 < _e3152));
let _e3219 = global_3.member[bitcast<u32>(select(0i, _e3213, (_e3213 > 0i)))];
let _e3220 = (_e3201 - _e483.member.x);
let _e3221 = (_e3210 - _e483.member.y);
let _e3222 = (_e3219 - _e483.member.z);
let _e3228 = select(select(_e3222, _e3221, _e3140), _e3220, _e3137);
let _e3230 = (select(select(_e3220, _e3222, _e3140), _e3221, _e3137) - (_e3148 * _e3228));
let _e3232 = (select(select(_e3221, _e3220, _e3140), _e3222, _e3137) - (_e3149 * _e3228));
let _e3234 = (_e3150 + 6i);
let _e3236 = select(_e3152, _e3234, (_e3234 < _e3152));
let _e3242 = global_3.member[bitcast<u32>(select(0i, _e3236, (_e3236 > 0i)))];
let _e3243 = (_e3150 + 7i);
let _e3245 = select(_e3152, _e3243, (_e3243 < _e3152));
let _e3251 = global_3.member[bitcast<u32>(select(0i, _e3245, (_e3245 > 0i)))];
let _e3252 = (_e3150 + 8i);
let _e3254 = select(_e3152, _e3252, (_e3252 < _e3152));
let _e3260 = global_3.member[bitcast<u32>(select(0i, _e3254, (_e3254 > 0i)))];
let _e3261 = (_e3242 - _e483.member.x);
let _e3262 = (_e3251 - _e483.member.y);
let _e3263 = (_e3260 - _e483.member.z);
let _e3269 = select(select(_e3263, _e3262, _e3140), _e3261, _e3137);
let _e3271 = (select(select(_e3261, _e3263, _e3140), _e3262, _e3137) - (_e3148 * _e3269));
let _e3273 = (select(select(_e3262, _e3261, _e3140), _e3263, _e3137) - (_e3149 * _e3269));
let _e3277 = ((_e3271 * _e3232) - (_e3273 * _e3230));
let _e3280 = ((_e3189 * _e3273) - (_e3191 * _e3271));
let _e3283 = ((_e3230 * _e3191) - (_e3232 * _e3189));
let _e3285 = ((_e3277 + _e3280) + _e3283);
let _e3299 = (!(((((_e3277 < 0f) || (_e3280 < 0f)) || (_e3283 < 0f)) && (((_e3277 > 0f) || (_e3280 > 0f)) || (_e3283 > 0f)))) && (_e3285 != 0f));
let _e3306 = ((((_e3277 * (_e3187 * _e3147)) + (_e3280 * (_e3228 * _e3147))) + (_e3283 * (_e3269 * _e3147))) / select(1f, _e3285, _e3299));
let _e3309 = select(1e30f, _e3306, (_e3299 && (_e3306 > 1e-3f)));
if (_e3309 < _e483.member_15) {
let _e3326 = type_20(_e483.member, _e483.member_1, _e483.member_2, _e483.member_3, _e483.member_4, _e483.member_5, _e483.member_6, _e483.member_7, _e483.member_8, _e483.member_9, _e483.member_10, _e483.member_11, _e483.member_12, _e483.member_13, _e483.member_14, _e3309);
phi_1413_ = type_20(_e3326.member, _e3326.member_1, _e3326.member_2, _e3326.member_3, _e3326.member_4, _e3326.member_5, _e3326.member_6, _e3326.member_7, _e3326.member_8, _e3326.member_9, _e3326.member_10, _e3326.member_11, _e3326.member_12, _e3326.member_13, _e3132, _e3326.member_15);
} else {
phi_1413_ = _e483;
}
let _e3344 = phi_1413_;
phi_1414_ = _e3344;
} else {
phi_1414_ = _e483;
}
let _e3346 = phi_1414_;
if _e3116 {
phi_1446_ = (_e3346.member_13 + 1i);
} else {
let _e3347 = (_e2993 + 7i);
let _e3349 = select(_e3022, _e3347, (_e3347 < _e3022));
let _e3355 = global_2.member[bitcast<u32>(select(0i, _e3349, (_e3349 > 0i)))];
phi_1446_ = select(0i, select(select(i32(_e3355), i32(-2147483648), (_e3355 < -2147483600f)), 2147483647i, (_e3355 > 2147483500f)), (_e3355 == _e3355));
}
let _e3366 = phi_1446_;
phi_4689_ = type_20(_e3346.member, _e3346.member_1, _e3346.member_2, _e3346.member_3, _e3346.member_4, _e3346.member_5, _e3346.member_6, _e3346.member_7, _e3346.member_8, _e3346.member_9, _e3346.member_10, _e3346.member_11, _e3346.member_12, _e3366, _e3346.member_14, _e3346.member_15);
phi_4690_ = _e487;
} else {
if (_e483.member_14 < 0i) {
phi_1454_ = 15i;
phi_1457_ = 16i;
loop {
let _e2510 = phi_1454_;
let _e2512 = phi_1457_;
local_12 = _e2512;
local_13 = _e2512;
local_14 = _e2512;
let _e2513 = (_e2510 >= 0i);
if _e2513 {
phi_1455_ = (_e2510 - 1i);
phi_1458_ = select(_e2512, _e2510, (((_e487 >> bitcast<u32>((_e2510 & 31i))) & 1i) == 1i));
} else {
phi_1455_ = i32();
phi_1458_ = i32();
}
let _e2522 = phi_1455_;
let _e2524 = phi_1458_;
continue;
continuing {
phi_1454_ = _e2522;
phi_1457_ = _e2524;
break if !(_e2513);
}
}
let _e2526 = (_e483.member_14 == -1i);
let _e2528 = local_12;
if (_e2526 || (_e2528 == 16i)) {
if _e2526 {
phi_1774_ = type_20(_e483.member, _e483.member_1, _e483.member_2, _e483.member_3, _e483.member_4, _e483.member_5, 1f, _e483.member_7, _e483.member_8, _e483.member_9, _e483.member_10, _e483.member_11, _e483.member_12, _e483.member_13, _e483.member_14, _e483.member_15);
} else {
let _e2895 = type_20(vec3<f32>((_e483.member.x + (_e483.member_1.x * _e483.member_15)), (_e483.member.y + (_e483.member_1.y * _e483.member_15)), (_e483.member.z + (_e483.member_1.z * _e483.member_15))), _e483.member_1, _e483.member_2, _e483.member_3, _e483.member_4, _e483.member_5, _e483.member_6, _e483.member_7, _e483.member_8, _e483.member_9, _e483.member_10, _e483.member_11, _e483.member_12, _e483.member_13, _e483.member_14, _e483.member_15);
let _e2913 = type_20(_e2895.member, _e2895.member_1, _e2895.member_2, _e2895.member_3, _e2895.member_4, (_e483.member_5 + _e483.member_15), _e2895.member_6, _e2895.member_7, _e2895.member_8, _e2895.member_9, _e2895.member_10, _e2895.member_11, _e2895.member_12, _e2895.member_13, _e2895.member_14, _e2895.member_15);
let _e2930 = type_20(_e2913.member, _e2913.member_1, _e2913.member_2, _e2913.member_3, _e2913.member_4, _e2913.member_5, _e2913.member_6, _e2913.member_7, _e2913.member_8, _e2913.member_9, _e2913.member_10, _e2913.member_11, _e2913.member_12, _e2913.member_13, _e2913.member_14, (_e483.member_15 - _e483.member_15));
let _e2951 = type_20(_e2930.member, _e2930.member_1, _e2930.member_2, _e2930.member_3, _e2930.member_4, _e2930.member_5, _e2930.member_6, _e2930.member_7, _e2930.member_8, _e2930.member_9, (_e483.member_10 + select(0f, _e483.member_15, (_e483.member_8 == 0f))), _e2930.member_11, _e2930.member_12, _e2930.member_13, _e2930.member_14, _e2930.member_15);
phi_1774_ = type_20(_e2951.member, _e2951.member_1, _e2951.member_2, _e2951.member_3, _e2951.member_4, _e2951.member_5, 3f, _e2951.member_7, _e2951.member_8, _e2951.member_9, _e2951.member_10, _e2951.member_11, _e2951.member_12, _e2951.member_13, _e2951.member_14, _e2951.member_15);
}
let _e2985 = phi_1774_;
phi_2062_ = _e2985;
} else {
let _e2564 = type_20(vec3<f32>((_e483.member.x + (_e483.member_1.x * _e483.member_15)), (_e483.member.y + (_e483.member_1.y * _e483.member_15)), (_e483.member.z + (_e483.member_1.z * _e483.member_15))), _e483.member_1, _e483.member_2, _e483.member_3, _e483.member_4, _e483.member_5, _e483.member_6, _e483.member_7, _e483.member_8, _e483.member_9, _e483.member_10, _e483.member_11, _e483.member_12, _e483.member_13, _e483.member_14, _e483.member_15);
let _e2582 = type_20(_e2564.member, _e2564.member_1, _e2564.member_2, _e2564.member_3, _e2564.member_4, (_e483.member_5 + _e483.member_15), _e2564.member_6, _e2564.member_7, _e2564.member_8, _e2564.member_9, _e2564.member_10, _e2564.member_11, _e2564.member_12, _e2564.member_13, _e2564.member_14, _e2564.member_15);
let _e2599 = type_20(_e2582.member, _e2582.member_1, _e2582.member_2, _e2582.member_3, _e2582.member_4, _e2582.member_5, _e2582.member_6, _e2582.member_7, _e2582.member_8, _e2582.member_9, _e2582.member_10, _e2582.member_11, _e2582.member_12, _e2582.member_13, _e2582.member_14, (_e483.member_15 - _e483.member_15));
let _e2620 = type_20(_e2599.member, _e2599.member_1, _e2599.member_2, _e2599.member_3, _e2599.member_4, _e2599.member_5, _e2599.member_6, _e2599.member_7, _e2599.member_8, _e2599.member_9, (_e483.member_10 + select(0f, _e483.member_15, (_e483.member_8 == 0f))), _e2599.member_11, _e2599.member_12, _e2599.member_13, _e2599.member_14, _e2599.member_15);
let _e2622 = local_13;
if (_e2622 != 16i) {
let _e2641 = type_20(_e2620.member, _e2620.member_1, _e2620.member_2, _e2620.member_3, _e2620.member_4, _e2620.member_5, _e2620.member_6, _e2620.member_7, _e2620.member_8, (_e483.member_9 + _e483.member_15), _e2620.member_10, _e2620.member_11, _e2620.member_12, _e2620.member_13, _e2620.member_14, _e2620.member_15);
let _e2643 = local_14;
let _e2644 = (_e2643 * 4i);
let _e2645 = (_e2644 + 1i);
let _e2647 = (bitcast<i32>(_e103) - 1i);
let _e2649 = select(_e2647, _e2645, (_e2645 < _e2647));
let _e2655 = global_4.member[bitcast<u32>(select(0i, _e2649, (_e2649 > 0i)))];
let _e2657 = -((_e2655 * _e483.member_15));
let _e2659 = select(-87f, _e2657, (_e2657 > -87f));
let _e2661 = select(88f, _e2659, (_e2659 < 88f));
let _e2663 = ((_e2661 * 1.442695f) + 0.5f);
let _e2665 = select(-127f, _e2663, (_e2663 > -127f));
let _e2667 = select(128f, _e2665, (_e2665 < 128f));
let _e2674 = select(0i, select(select(i32(_e2667), i32(-2147483648), (_e2667 < -2147483600f)), 2147483647i, (_e2667 > 2147483500f)), (_e2667 == _e2667));
let _e2678 = (_e2674 - select(0i, 1i, (_e2667 < f32(_e2674))));
let _e2679 = f32(_e2678);
let _e2683 = ((_e2661 - (_e2679 * 0.6933594f)) - (_e2679 * -2.1219444e-4f));
let _e2704 = (_e2644 + 2i);
let _e2706 = select(_e2647, _e2704, (_e2704 < _e2647));
let _e2712 = global_4.member[bitcast<u32>(select(0i, _e2706, (_e2706 > 0i)))];
let _e2714 = -((_e2712 * _e483.member_15));
let _e2716 = select(-87f, _e2714, (_e2714 > -87f));
let _e2718 = select(88f, _e2716, (_e2716 < 88f));
let _e2720 = ((_e2718 * 1.442695f) + 0.5f);
let _e2722 = select(-127f, _e2720, (_e2720 > -127f));
let _e2724 = select(128f, _e2722, (_e2722 < 128f));
let _e2731 = select(0i, select(select(i32(_e2724), i32(-2147483648), (_e2724 < -2147483600f)), 2147483647i, (_e2724 > 2147483500f)), (_e2724 == _e2724));
let _e2735 = (_e2731 - select(0i, 1i, (_e2724 < f32(_e2731))));
let _e2736 = f32(_e2735);
let _e2740 = ((_e2718 - (_e2736 * 0.6933594f)) - (_e2736 * -2.1219444e-4f));
let _e2761 = (_e2644 + 3i);
let _e2763 = select(_e2647, _e2761, (_e2761 < _e2647));
let _e2769 = global_4.member[bitcast<u32>(select(0i, _e2763, (_e2763 > 0i)))];
let _e2771 = -((_e2769 * _e483.member_15));
let _e2773 = select(-87f, _e2771, (_e2771 > -87f));
let _e2775 = select(88f, _e2773, (_e2773 < 88f));
let _e2777 = ((_e2775 * 1.442695f) + 0.5f);
let _e2779 = select(-127f, _e2777, (_e2777 > -127f));
let _e2781 = select(128f, _e2779, (_e2779 < 128f));
let _e2788 = select(0i, select(select(i32(_e2781), i32(-2147483648), (_e2781 < -2147483600f)), 2147483647i, (_e2781 > 2147483500f)), (_e2781 == _e2781));
let _e2792 = (_e2788 - select(0i, 1i, (_e2781 < f32(_e2788))));
let _e2793 = f32(_e2792);
let _e2797 = ((_e2775 - (_e2793 * 0.6933594f)) - (_e2793 * -2.1219444e-4f));
phi_2060_ = type_20(_e2641.member, _e2641.member_1, vec3<f32>((_e483.member_2.x * ((1f + (_e2683 * (1f + (_e2683 * (0.5f + (_e2683 * (0.16666667f + (_e2683 * (0.041666668f + (_e2683 * (0.008333334f + (_e2683 * (0.001388889f + (_e2683 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2678 + 127i)) << bitcast<u32>(23i))))), (_e483.member_2.y * ((1f + (_e2740 * (1f + (_e2740 * (0.5f + (_e2740 * (0.16666667f + (_e2740 * (0.041666668f + (_e2740 * (0.008333334f + (_e2740 * (0.001388889f + (_e2740 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2735 + 127i)) << bitcast<u32>(23i))))), (_e483.member_2.z * ((1f + (_e2797 * (1f + (_e2797 * (0.5f + (_e2797 * (0.16666667f + (_e2797 * (0.041666668f + (_e2797 * (0.008333334f + (_e2797 * (0.001388889f + (_e2797 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2792 + 127i)) << bitcast<u32>(23i)))))), _e2641.member_3, _e2641.member_4, _e2641.member_5, _e2641.member_6, _e2641.member_7, _e2641.member_8, _e2641.member_9, _e2641.member_10, _e2641.member_11, _e2641.member_12, _e2641.member_13, _e2641.member_14, _e2641.member_15);
} else {
phi_2060_ = _e2620;
}
let _e2845 = phi_2060_;
phi_2062_ = type_20(_e2845.member, _e2845.member_1, _e2845.member_2, _e2845.member_3, _e2845.member_4, _e2845.member_5, 3f, _e2845.member_7, _e2845.member_8, _e2845.member_9, _e2845.member_10, _e2845.member_11, _e2845.member_12, _e2845.member_13, _e2845.member_14, _e2845.member_15);
}
let _e2987 = phi_2062_;
phi_4687_ = _e2987;
phi_4688_ = _e487;
} else {
phi_2064_ = 15i;
phi_2067_ = 16i;
loop {
let _e498 = phi_2064_;
let _e500 = phi_2067_;
local = _e500;
local_1 = _e500;
local_2 = _e500;
local_4 = _e500;
local_5 = _e500;
local_8 = _e500;
local_10 = _e500;
local_11 = _e500;
let _e501 = (_e498 >= 0i);
if _e501 {
phi_2065_ = (_e498 - 1i);
phi_2068_ = select(_e500, _e498, (((_e487 >> bitcast<u32>((_e498 & 31i))) & 1i) == 1i));
} else {
phi_2065_ = i32();
phi_2068_ = i32();
}
let _e510 = phi_2065_;
let _e512 = phi_2068_;
continue;
continuing {
phi_2064_ = _e510;
phi_2067_ = _e512;
break if !(_e501);
}
}
let _e514 = (_e483.member_14 * 19i);
let _e516 = (bitcast<i32>(_e101) - 1i);
let _e518 = select(_e516, _e514, (_e514 < _e516));
let _e524 = global_3.member[bitcast<u32>(select(0i, _e518, (_e518 > 0i)))];
let _e525 = (_e514 + 1i);
let _e527 = select(_e516, _e525, (_e525 < _e516));
let _e533 = global_3.member[bitcast<u32>(select(0i, _e527, (_e527 > 0i)))];
let _e534 = (_e514 + 2i);
let _e536 = select(_e516, _e534, (_e534 < _e516));
let _e542 = global_3.member[bitcast<u32>(select(0i, _e536, (_e536 > 0i)))];
let _e543 = (_e514 + 3i);
let _e545 = select(_e516, _e543, (_e543 < _e516));
let _e551 = global_3.member[bitcast<u32>(select(0i, _e545, (_e545 > 0i)))];
let _e552 = (_e514 + 4i);
let _e554 = select(_e516, _e552, (_e552 < _e516));
let _e560 = global_3.member[bitcast<u32>(select(0i, _e554, (_e554 > 0i)))];
let _e561 = (_e514 + 5i);
let _e563 = select(_e516, _e561, (_e561 < _e516));
let _e569 = global_3.member[bitcast<u32>(select(0i, _e563, (_e563 > 0i)))];
let _e570 = (_e514 + 6i);
let _e572 = select(_e516, _e570, (_e570 < _e516));
let _e578 = global_3.member[bitcast<u32>(select(0i, _e572, (_e572 > 0i)))];
let _e579 = (_e514 + 7i);
let _e581 = select(_e516, _e579, (_e579 < _e516));
let _e587 = global_3.member[bitcast<u32>(select(0i, _e581, (_e581 > 0i)))];
let _e588 = (_e514 + 8i);
let _e590 = select(_e516, _e588, (_e588 < _e516));
let _e596 = global_3.member[bitcast<u32>(select(0i, _e590, (_e590 > 0i)))];
let _e597 = (_e551 - _e524);
let _e598 = (_e560 - _e533);
let _e599 = (_e569 - _e542);
let _e600 = (_e578 - _e524);
let _e601 = (_e587 - _e533);
let _e602 = (_e596 - _e542);
let _e605 = ((_e598 * _e602) - (_e599 * _e601));
let _e608 = ((_e599 * _e600) - (_e597 * _e602));
let _e611 = ((_e597 * _e601) - (_e598 * _e600));
let _e616 = (((_e605 * _e605) + (_e608 * _e608)) + (_e611 * _e611));
let _e619 = sqrt(select(0f, _e616, (_e616 > 0f)));
let _e622 = (1f / select(1e-20f, _e619, (_e619 > 1e-20f)));
let _e623 = (_e605 * _e622);
let _e624 = (_e608 * _e622);
let _e625 = (_e611 * _e622);
let _e631 = bitcast<f32>((bitcast<u32>(_e483.member_1.x) & 2147483647u));
let _e635 = bitcast<f32>((bitcast<u32>(_e483.member_1.y) & 2147483647u));
let _e639 = bitcast<f32>((bitcast<u32>(_e483.member_1.z) & 2147483647u));
let _e642 = ((_e631 >= _e635) && (_e631 >= _e639));
let _e645 = (!(_e642) && (_e635 >= _e639));
let _e652 = (1f / select(select(_e483.member_1.z, _e483.member_1.y, _e645), _e483.member_1.x, _e642));
let _e653 = (select(select(_e483.member_1.x, _e483.member_1.z, _e645), _e483.member_1.y, _e642) * _e652);
let _e654 = (select(select(_e483.member_1.y, _e483.member_1.x, _e645), _e483.member_1.z, _e642) * _e652);
let _e656 = (_e524 - _e483.member.x);
let _e658 = (_e533 - _e483.member.y);
let _e660 = (_e542 - _e483.member.z);
let _e666 = select(select(_e660, _e658, _e645), _e656, _e642);
let _e668 = (select(select(_e656, _e660, _e645), _e658, _e642) - (_e653 * _e666));
let _e670 = (select(select(_e658, _e656, _e645), _e660, _e642) - (_e654 * _e666));
let _e671 = (_e551 - _e483.member.x);
let _e672 = (_e560 - _e483.member.y);
let _e673 = (_e569 - _e483.member.z);
let _e679 = select(select(_e673, _e672, _e645), _e671, _e642);
let _e681 = (select(select(_e671, _e673, _e645), _e672, _e642) - (_e653 * _e679));
let _e683 = (select(select(_e672, _e671, _e645), _e673, _e642) - (_e654 * _e679));
let _e684 = (_e578 - _e483.member.x);
let _e685 = (_e587 - _e483.member.y);
let _e686 = (_e596 - _e483.member.z);
let _e692 = select(select(_e686, _e685, _e645), _e684, _e642);
let _e694 = (select(select(_e684, _e686, _e645), _e685, _e642) - (_e653 * _e692));
let _e696 = (select(select(_e685, _e684, _e645), _e686, _e642) - (_e654 * _e692));
let _e699 = ((_e694 * _e683) - (_e696 * _e681));
let _e702 = ((_e668 * _e696) - (_e670 * _e694));
let _e705 = ((_e681 * _e670) - (_e683 * _e668));
let _e707 = ((_e699 + _e702) + _e705);
let _e710 = (1f / select(_e707, 1f, (_e707 == 0f)));
let _e711 = (_e699 * _e710);
let _e712 = (_e702 * _e710);
let _e713 = (_e705 * _e710);
let _e714 = (_e514 + 9i);
let _e716 = select(_e516, _e714, (_e714 < _e516));
let _e722 = global_3.member[bitcast<u32>(select(0i, _e716, (_e716 > 0i)))];
let _e723 = (_e514 + 10i);
let _e725 = select(_e516, _e723, (_e723 < _e516));
let _e731 = global_3.member[bitcast<u32>(select(0i, _e725, (_e725 > 0i)))];
let _e732 = (_e514 + 11i);
let _e734 = select(_e516, _e732, (_e732 < _e516));
let _e740 = global_3.member[bitcast<u32>(select(0i, _e734, (_e734 > 0i)))];
let _e744 = (_e514 + 12i);
let _e746 = select(_e516, _e744, (_e744 < _e516));
let _e752 = global_3.member[bitcast<u32>(select(0i, _e746, (_e746 > 0i)))];
let _e753 = (_e514 + 13i);
let _e755 = select(_e516, _e753, (_e753 < _e516));
let _e761 = global_3.member[bitcast<u32>(select(0i, _e755, (_e755 > 0i)))];
let _e762 = (_e514 + 14i);
let _e764 = select(_e516, _e762, (_e762 < _e516));
let _e770 = global_3.member[bitcast<u32>(select(0i, _e764, (_e764 > 0i)))];
let _e777 = (_e514 + 15i);
let _e779 = select(_e516, _e777, (_e777 < _e516));
let _e785 = global_3.member[bitcast<u32>(select(0i, _e779, (_e779 > 0i)))];
let _e786 = (_e514 + 16i);
let _e788 = select(_e516, _e786, (_e786 < _e516));
let _e794 = global_3.member[bitcast<u32>(select(0i, _e788, (_e788 > 0i)))];
let _e795 = (_e514 + 17i);
let _e797 = select(_e516, _e795, (_e795 < _e516));
let _e803 = global_3.member[bitcast<u32>(select(0i, _e797, (_e797 > 0i)))];
let _e807 = (((_e722 * _e711) + (_e752 * _e712)) + (_e785 * _e713));
let _e808 = (((_e731 * _e711) + (_e761 * _e712)) + (_e794 * _e713));
let _e809 = (((_e740 * _e711) + (_e770 * _e712)) + (_e803 * _e713));
let _e814 = (((_e807 * _e807) + (_e808 * _e808)) + (_e809 * _e809));
let _e817 = sqrt(select(0f, _e814, (_e814 > 0f)));
let _e820 = (1f / select(1e-20f, _e817, (_e817 > 1e-20f)));
let _e821 = (_e807 * _e820);
let _e822 = (_e808 * _e820);
let _e823 = (_e809 * _e820);
let _e835 = (((((_e821 * _e483.member_1.x) + (_e822 * _e483.member_1.y)) + (_e823 * _e483.member_1.z)) * (((_e623 * _e483.member_1.x) + (_e624 * _e483.member_1.y)) + (_e625 * _e483.member_1.z))) > 0f);
let _e836 = select(_e623, _e821, _e835);
let _e837 = select(_e624, _e822, _e835);
let _e838 = select(_e625, _e823, _e835);
let _e840 = (_e514 + 18i);
let _e842 = select(_e516, _e840, (_e840 < _e516));
let _e848 = global_3.member[bitcast<u32>(select(0i, _e842, (_e842 > 0i)))];
let _e855 = select(0i, select(select(i32(_e848), i32(-2147483648), (_e848 < -2147483600f)), 2147483647i, (_e848 > 2147483500f)), (_e848 == _e848));
let _e856 = (_e855 * 4i);
let _e858 = (bitcast<i32>(_e103) - 1i);
let _e860 = select(_e858, _e856, (_e856 < _e858));
let _e866 = global_4.member[bitcast<u32>(select(0i, _e860, (_e860 > 0i)))];
if (select(_e866, 1f, (_e855 == 16i)) == 0f) {
let _e2209 = type_20(vec3<f32>((_e483.member.x + (_e483.member_1.x * _e483.member_15)), (_e483.member.y + (_e483.member_1.y * _e483.member_15)), (_e483.member.z + (_e483.member_1.z * _e483.member_15))), _e483.member_1, _e483.member_2, _e483.member_3, _e483.member_4, _e483.member_5, _e483.member_6, _e483.member_7, _e483.member_8, _e483.member_9, _e483.member_10, _e483.member_11, _e483.member_12, _e483.member_13, _e483.member_14, _e483.member_15);
let _e2227 = type_20(_e2209.member, _e2209.member_1, _e2209.member_2, _e2209.member_3, _e2209.member_4, (_e483.member_5 + _e483.member_15), _e2209.member_6, _e2209.member_7, _e2209.member_8, _e2209.member_9, _e2209.member_10, _e2209.member_11, _e2209.member_12, _e2209.member_13, _e2209.member_14, _e2209.member_15);
let _e2244 = type_20(_e2227.member, _e2227.member_1, _e2227.member_2, _e2227.member_3, _e2227.member_4, _e2227.member_5, _e2227.member_6, _e2227.member_7, _e2227.member_8, _e2227.member_9, _e2227.member_10, _e2227.member_11, _e2227.member_12, _e2227.member_13, _e2227.member_14, (_e483.member_15 - _e483.member_15));
let _e2265 = type_20(_e2244.member, _e2244.member_1, _e2244.member_2, _e2244.member_3, _e2244.member_4, _e2244.member_5, _e2244.member_6, _e2244.member_7, _e2244.member_8, _e2244.member_9, (_e483.member_10 + select(0f, _e483.member_15, (_e483.member_8 == 0f))), _e2244.member_11, _e2244.member_12, _e2244.member_13, _e2244.member_14, _e2244.member_15);
let _e2267 = local_10;
if (_e2267 != 16i) {
let _e2286 = type_20(_e2265.member, _e2265.member_1, _e2265.member_2, _e2265.member_3, _e2265.member_4, _e2265.member_5, _e2265.member_6, _e2265.member_7, _e2265.member_8, (_e483.member_9 + _e483.member_15), _e2265.member_10, _e2265.member_11, _e2265.member_12, _e2265.member_13, _e2265.member_14, _e2265.member_15);
let _e2288 = local_11;
let _e2289 = (_e2288 * 4i);
let _e2290 = (_e2289 + 1i);
let _e2292 = select(_e858, _e2290, (_e2290 < _e858));
let _e2298 = global_4.member[bitcast<u32>(select(0i, _e2292, (_e2292 > 0i)))];
let _e2300 = -((_e2298 * _e483.member_15));
let _e2302 = select(-87f, _e2300, (_e2300 > -87f));
let _e2304 = select(88f, _e2302, (_e2302 < 88f));
let _e2306 = ((_e2304 * 1.442695f) + 0.5f);
let _e2308 = select(-127f, _e2306, (_e2306 > -127f));
let _e2310 = select(128f, _e2308, (_e2308 < 128f));
let _e2317 = select(0i, select(select(i32(_e2310), i32(-2147483648), (_e2310 < -2147483600f)), 2147483647i, (_e2310 > 2147483500f)), (_e2310 == _e2310));
let _e2321 = (_e2317 - select(0i, 1i, (_e2310 < f32(_e2317))));
let _e2322 = f32(_e2321);
let _e2326 = ((_e2304 - (_e2322 * 0.6933594f)) - (_e2322 * -2.1219444e-4f));
let _e2347 = (_e2289 + 2i);
let _e2349 = select(_e858, _e2347, (_e2347 < _e858));
let _e2355 = global_4.member[bitcast<u32>(select(0i, _e2349, (_e2349 > 0i)))];
let _e2357 = -((_e2355 * _e483.member_15));
let _e2359 = select(-87f, _e2357, (_e2357 > -87f));
let _e2361 = select(88f, _e2359, (_e2359 < 88f));
let _e2363 = ((_e2361 * 1.442695f) + 0.5f);
let _e2365 = select(-127f, _e2363, (_e2363 > -127f));
let _e2367 = select(128f, _e2365, (_e2365 < 128f));
let _e2374 = select(0i, select(select(i32(_e2367), i32(-2147483648), (_e2367 < -2147483600f)), 2147483647i, (_e2367 > 2147483500f)), (_e2367 == _e2367));
let _e2378 = (_e2374 - select(0i, 1i, (_e2367 < f32(_e2374))));
let _e2379 = f32(_e2378);
let _e2383 = ((_e2361 - (_e2379 * 0.6933594f)) - (_e2379 * -2.1219444e-4f));
let _e2404 = (_e2289 + 3i);
let _e2406 = select(_e858, _e2404, (_e2404 < _e858));
let _e2412 = global_4.member[bitcast<u32>(select(0i, _e2406, (_e2406 > 0i)))];
let _e2414 = -((_e2412 * _e483.member_15));
let _e2416 = select(-87f, _e2414, (_e2414 > -87f));
let _e2418 = select(88f, _e2416, (_e2416 < 88f));
let _e2420 = ((_e2418 * 1.442695f) + 0.5f);
let _e2422 = select(-127f, _e2420, (_e2420 > -127f));
let _e2424 = select(128f, _e2422, (_e2422 < 128f));
let _e2431 = select(0i, select(select(i32(_e2424), i32(-2147483648), (_e2424 < -2147483600f)), 2147483647i, (_e2424 > 2147483500f)), (_e2424 == _e2424));
let _e2435 = (_e2431 - select(0i, 1i, (_e2424 < f32(_e2431))));
let _e2436 = f32(_e2435);
let _e2440 = ((_e2418 - (_e2436 * 0.6933594f)) - (_e2436 * -2.1219444e-4f));
phi_3159_ = type_20(_e2286.member, _e2286.member_1, vec3<f32>((_e483.member_2.x * ((1f + (_e2326 * (1f + (_e2326 * (0.5f + (_e2326 * (0.16666667f + (_e2326 * (0.041666668f + (_e2326 * (0.008333334f + (_e2326 * (0.001388889f + (_e2326 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2321 + 127i)) << bitcast<u32>(23i))))), (_e483.member_2.y * ((1f + (_e2383 * (1f + (_e2383 * (0.5f + (_e2383 * (0.16666667f + (_e2383 * (0.041666668f + (_e2383 * (0.008333334f + (_e2383 * (0.001388889f + (_e2383 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2378 + 127i)) << bitcast<u32>(23i))))), (_e483.member_2.z * ((1f + (_e2440 * (1f + (_e2440 * (0.5f + (_e2440 * (0.16666667f + (_e2440 * (0.041666668f + (_e2440 * (0.008333334f + (_e2440 * (0.001388889f + (_e2440 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2435 + 127i)) << bitcast<u32>(23i)))))), _e2286.member_3, _e2286.member_4, _e2286.member_5, _e2286.member_6, _e2286.member_7, _e2286.member_8, _e2286.member_9, _e2286.member_10, _e2286.member_11, _e2286.member_12, _e2286.member_13, _e2286.member_14, _e2286.member_15);
} else {
phi_3159_ = _e2265;
}
let _e2488 = phi_3159_;
phi_4685_ = type_20(_e2488.member, _e2488.member_1, _e2488.member_2, _e2488.member_3, _e2488.member_4, _e2488.member_5, 3f, _e2488.member_7, _e2488.member_8, _e2488.member_9, _e2488.member_10, _e2488.member_11, _e2488.member_12, _e2488.member_13, _e2488.member_14, _e2488.member_15);
phi_4686_ = _e487;
} else {
let _e872 = (1i << bitcast<u32>((_e855 & 31i)));
if ((((_e483.member_1.x * _e623) + (_e483.member_1.y * _e624)) + (_e483.member_1.z * _e625)) < 0f) {
phi_3179_ = (_e487 | _e872);
} else {
phi_3179_ = (_e487 & ~(_e872));
}
let _e883 = phi_3179_;
phi_3181_ = 15i;
phi_3184_ = 16i;
loop {
let _e885 = phi_3181_;
let _e887 = phi_3184_;
local_3 = _e887;
local_6 = _e887;
local_7 = _e887;
local_9 = _e887;
let _e888 = (_e885 >= 0i);
if _e888 {
phi_3182_ = (_e885 - 1i);
phi_3185_ = select(_e887, _e885, (((_e883 >> bitcast<u32>((_e885 & 31i))) & 1i) == 1i));
} else {
phi_3182_ = i32();
phi_3185_ = i32();
}
let _e897 = phi_3182_;
let _e899 = phi_3185_;
continue;
continuing {
phi_3181_ = _e897;
phi_3184_ = _e899;
break if !(_e888);
}
}
let _e930 = type_20(vec3<f32>((_e483.member.x + (_e483.member_1.x * _e483.member_15)), (_e483.member.y + (_e483.member_1.y * _e483.member_15)), (_e483.member.z + (_e483.member_1.z * _e483.member_15))), _e483.member_1, _e483.member_2, _e483.member_3, _e483.member_4, _e483.member_5, _e483.member_6, _e483.member_7, _e483.member_8, _e483.member_9, _e483.member_10, _e483.member_11, _e483.member_12, _e483.member_13, _e483.member_14, _e483.member_15);
let _e948 = type_20(_e930.member, _e930.member_1, _e930.member_2, _e930.member_3, _e930.member_4, (_e483.member_5 + _e483.member_15), _e930.member_6, _e930.member_7, _e930.member_8, _e930.member_9, _e930.member_10, _e930.member_11, _e930.member_12, _e930.member_13, _e930.member_14, _e930.member_15);
let _e969 = type_20(_e948.member, _e948.member_1, _e948.member_2, _e948.member_3, _e948.member_4, _e948.member_5, _e948.member_6, _e948.member_7, _e948.member_8, _e948.member_9, (_e483.member_10 + select(0f, _e483.member_15, (_e483.member_8 == 0f))), _e948.member_11, _e948.member_12, _e948.member_13, _e948.member_14, _e948.member_15);
let _e971 = local;
if (_e971 != 16i) {
let _e990 = type_20(_e969.member, _e969.member_1, _e969.member_2, _e969.member_3, _e969.member_4, _e969.member_5, _e969.member_6, _e969.member_7, _e969.member_8, (_e483.member_9 + _e483.member_15), _e969.member_10, _e969.member_11, _e969.member_12, _e969.member_13, _e969.member_14, _e969.member_15);
let _e992 = local_1;
let _e993 = (_e992 * 4i);
let _e994 = (_e993 + 1i);
let _e996 = select(_e858, _e994, (_e994 < _e858));
let _e1002 = global_4.member[bitcast<u32>(select(0i, _e996, (_e996 > 0i)))];
let _e1004 = -((_e1002 * _e483.member_15));
let _e1006 = select(-87f, _e1004, (_e1004 > -87f));
let _e1008 = select(88f, _e1006, (_e1006 < 88f));
let _e1010 = ((_e1008 * 1.442695f) + 0.5f);
let _e1012 = select(-127f, _e1010, (_e1010 > -127f));
let _e1014 = select(128f, _e1012, (_e1012 < 128f));
let _e1021 = select(0i, select(select(i32(_e1014), i32(-2147483648), (_e1014 < -2147483600f)), 2147483647i, (_e1014 > 2147483500f)), (_e1014 == _e1014));
let _e1025 = (_e1021 - select(0i, 1i, (_e1014 < f32(_e1021))));
let _e1026 = f32(_e1025);
let _e1030 = ((_e1008 - (_e1026 * 0.6933594f)) - (_e1026 * -2.1219444e-4f));
let _e1051 = (_e993 + 2i);
let _e1053 = select(_e858, _e1051, (_e1051 < _e858));
let _e1059 = global_4.member[bitcast<u32>(select(0i, _e1053, (_e1053 > 0i)))];
let _e1061 = -((_e1059 * _e483.member_15));
let _e1063 = select(-87f, _e1061, (_e1061 > -87f));
let _e1065 = select(88f, _e1063, (_e1063 < 88f));
let _e1067 = ((_e1065 * 1.442695f) + 0.5f);
let _e1069 = select(-127f, _e1067, (_e1067 > -127f));
let _e1071 = select(128f, _e1069, (_e1069 < 128f));
let _e1078 = select(0i, select(select(i32(_e1071), i32(-2147483648), (_e1071 < -2147483600f)), 2147483647i, (_e1071 > 2147483500f)), (_e1071 == _e1071));
let _e1082 = (_e1078 - select(0i, 1i, (_e1071 < f32(_e1078))));
let _e1083 = f32(_e1082);
let _e1087 = ((_e1065 - (_e1083 * 0.6933594f)) - (_e1083 * -2.1219444e-4f));
let _e1108 = (_e993 + 3i);
let _e1110 = select(_e858, _e1108, (_e1108 < _e858));
let _e1116 = global_4.member[bitcast<u32>(select(0i, _e1110, (_e1110 > 0i)))];
let _e1118 = -((_e1116 * _e483.member_15));
let _e1120 = select(-87f, _e1118, (_e1118 > -87f));
let _e1122 = select(88f, _e1120, (_e1120 < 88f));
let _e1124 = ((_e1122 * 1.442695f) + 0.5f);
let _e1126 = select(-127f, _e1124, (_e1124 > -127f));
let _e1128 = select(128f, _e1126, (_e1126 < 128f));
let _e1135 = select(0i, select(select(i32(_e1128), i32(-2147483648), (_e1128 < -2147483600f)), 2147483647i, (_e1128 > 2147483500f)), (_e1128 == _e1128));
let _e1139 = (_e1135 - select(0i, 1i, (_e1128 < f32(_e1135))));
let _e1140 = f32(_e1139);
let _e1144 = ((_e1122 - (_e1140 * 0.6933594f)) - (_e1140 * -2.1219444e-4f));
phi_3486_ = type_20(_e990.member, _e990.member_1, vec3<f32>((_e483.member_2.x * ((1f + (_e1030 * (1f + (_e1030 * (0.5f + (_e1030 * (0.16666667f + (_e1030 * (0.041666668f + (_e1030 * (0.008333334f + (_e1030 * (0.001388889f + (_e1030 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1025 + 127i)) << bitcast<u32>(23i))))), (_e483.member_2.y * ((1f + (_e1087 * (1f + (_e1087 * (0.5f + (_e1087 * (0.16666667f + (_e1087 * (0.041666668f + (_e1087 * (0.008333334f + (_e1087 * (0.001388889f + (_e1087 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1082 + 127i)) << bitcast<u32>(23i))))), (_e483.member_2.z * ((1f + (_e1144 * (1f + (_e1144 * (0.5f + (_e1144 * (0.16666667f + (_e1144 * (0.041666668f + (_e1144 * (0.008333334f + (_e1144 * (0.001388889f + (_e1144 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1139 + 127i)) << bitcast<u32>(23i)))))), _e990.member_3, _e990.member_4, _e990.member_5, _e990.member_6, _e990.member_7, _e990.member_8, _e990.member_9, _e990.member_10, _e990.member_11, _e990.member_12, _e990.member_13, _e990.member_14, _e990.member_15);
} else {
phi_3486_ = _e969;
}
let _e1192 = phi_3486_;
let _e1194 = local_2;
let _e1196 = local_3;
if (_e1194 == _e1196) {
let _e2052 = global_1.member.member_18.member.member;
let _e2066 = ((((_e2052.member.member * _e1192.member.x) + (_e2052.member.member_1 * _e1192.member.y)) + (_e2052.member.member_2 * _e1192.member.z)) + _e2052.member_1);
let _e2075 = -((((_e2052.member.member * _e1192.member_1.x) + (_e2052.member.member_1 * _e1192.member_1.y)) + (_e2052.member.member_2 * _e1192.member_1.z)));
let _e2077 = (_e2075 > 1e-9f);
let _e2081 = ((_e2066 / select(1e-9f, _e2075, _e2077)) - 0.015625f);
let _e2084 = select(1e30f, select(0f, _e2081, (_e2081 > 0f)), ((_e2066 > 0f) && _e2077));
let _e2089 = global_1.member.member_18.member_1.member;
let _e2100 = ((((_e2089.member.member * _e1192.member.x) + (_e2089.member.member_1 * _e1192.member.y)) + (_e2089.member.member_2 * _e1192.member.z)) + _e2089.member_1);
let _e2106 = -((((_e2089.member.member * _e1192.member_1.x) + (_e2089.member.member_1 * _e1192.member_1.y)) + (_e2089.member.member_2 * _e1192.member_1.z)));
let _e2108 = (_e2106 > 1e-9f);
let _e2112 = ((_e2100 / select(1e-9f, _e2106, _e2108)) - 0.015625f);
let _e2115 = select(1e30f, select(0f, _e2112, (_e2112 > 0f)), ((_e2100 > 0f) && _e2108));
let _e2119 = (_e2115 < _e2084);
let _e2138 = type_20(_e1192.member, _e1192.member_1, _e1192.member_2, _e1192.member_3, _e1192.member_4, _e1192.member_5, _e1192.member_6, _e1192.member_7, _e1192.member_8, _e1192.member_9, _e1192.member_10, _e1192.member_11, _e1192.member_12, 0i, _e1192.member_14, _e1192.member_15);
let _e2154 = type_20(_e2138.member, _e2138.member_1, _e2138.member_2, _e2138.member_3, _e2138.member_4, _e2138.member_5, _e2138.member_6, _e2138.member_7, _e2138.member_8, _e2138.member_9, _e2138.member_10, _e2138.member_11, _e2138.member_12, _e2138.member_13, select(select(-2i, -3i, _e2119), -1i, ((_e2084 >= 1e30f) && (_e2115 >= 1e30f))), _e2138.member_15);
phi_4677_ = type_20(_e2154.member, _e2154.member_1, _e2154.member_2, _e2154.member_3, _e2154.member_4, _e2154.member_5, _e2154.member_6, _e2154.member_7, _e2154.member_8, _e2154.member_9, _e2154.member_10, _e2154.member_11, _e2154.member_12, _e2154.member_13, _e2154.member_14, select(_e2084, _e2115, _e2119));
phi_4678_ = type_20();
phi_4679_ = true;
} else {
let _e1200 = local_4;
let _e1201 = (_e1200 * 4i);
let _e1203 = select(_e858, _e1201, (_e1201 < _e858));
let _e1209 = global_4.member[bitcast<u32>(select(0i, _e1203, (_e1203 > 0i)))];
let _e1211 = local_5;
let _e1212 = (_e1211 == 16i);
let _e1213 = select(_e1209, 1f, _e1212);
let _e1215 = local_6;
let _e1216 = (_e1215 * 4i);
let _e1218 = select(_e858, _e1216, (_e1216 < _e858));
let _e1224 = global_4.member[bitcast<u32>(select(0i, _e1218, (_e1218 > 0i)))];
let _e1226 = local_7;
let _e1228 = select(_e1224, 1f, (_e1226 == 16i));
let _e1238 = select(1f, -1f, ((((_e1192.member_1.x * _e836) + (_e1192.member_1.y * _e837)) + (_e1192.member_1.z * _e838)) > 0f));
let _e1239 = (_e836 * _e1238);
let _e1240 = (_e837 * _e1238);
let _e1241 = (_e838 * _e1238);
let _e1247 = -((((_e1192.member_1.x * _e1239) + (_e1192.member_1.y * _e1240)) + (_e1192.member_1.z * _e1241)));
let _e1249 = select(0f, _e1247, (_e1247 > 0f));
let _e1250 = (_e1213 / _e1228);
let _e1252 = (_e1249 * _e1249);
let _e1255 = (1f - ((_e1250 * _e1250) * (1f - _e1252)));
let _e1256 = (_e1255 <= 0f);
let _e1264 = ((_e1250 * _e1249) - sqrt(select(0f, _e1255, (_e1255 > 0f))));
let _e1271 = (2f * _e1249);
let _e1278 = select(((_e1192.member_1.x * _e1250) + (_e1239 * _e1264)), (_e1192.member_1.x + (_e1239 * _e1271)), _e1256);
let _e1279 = select(((_e1192.member_1.y * _e1250) + (_e1240 * _e1264)), (_e1192.member_1.y + (_e1240 * _e1271)), _e1256);
let _e1280 = select(((_e1192.member_1.z * _e1250) + (_e1241 * _e1264)), (_e1192.member_1.z + (_e1241 * _e1271)), _e1256);
let _e1285 = (((_e1278 * _e1278) + (_e1279 * _e1279)) + (_e1280 * _e1280));
let _e1288 = sqrt(select(0f, _e1285, (_e1285 > 0f)));
let _e1291 = (1f / select(1e-20f, _e1288, (_e1288 > 1e-20f)));
let _e1296 = (_e1228 / _e1213);
let _e1299 = (((_e1296 * _e1296) - 1f) + _e1252);
let _e1302 = sqrt(select(0f, _e1299, (_e1299 > 0f)));
let _e1303 = (_e1302 - _e1249);
let _e1304 = (_e1302 + _e1249);
let _e1307 = (_e1303 / select(1e-6f, _e1304, (_e1304 > 1e-6f)));
let _e1311 = ((_e1249 * _e1303) + 1f);
let _e1314 = (((_e1249 * _e1304) - 1f) / select(1e-6f, _e1311, (_e1311 > 1e-6f)));
let _e1325 = (_e1192.member_8 == 0f);
let _e1328 = global_1.member.member_1;
let _e1331 = select(0f, select(select((((0.5f * _e1307) * _e1307) * (1f + (_e1314 * _e1314))), 1f, (_e1299 <= 0f)), 0f, (_e1213 == _e1228)), ((_e1328 & 1u) != 0u));
let _e1332 = (_e1325 && _e1212);
if _e1325 {
let _e1348 = type_20(_e1192.member, _e1192.member_1, _e1192.member_2, vec3<f32>(_e836, _e837, _e838), _e1192.member_4, _e1192.member_5, _e1192.member_6, _e1192.member_7, _e1192.member_8, _e1192.member_9, _e1192.member_10, _e1192.member_11, _e1192.member_12, _e1192.member_13, _e1192.member_14, _e1192.member_15);
phi_3827_ = type_20(_e1348.member, _e1348.member_1, _e1348.member_2, _e1348.member_3, _e1348.member_4, _e1348.member_5, _e1348.member_6, _e1348.member_7, _e1348.member_8, _e1348.member_9, _e1348.member_10, select(0f, _e1331, _e1332), _e1348.member_12, _e1348.member_13, _e1348.member_14, _e1348.member_15);
} else {
phi_3827_ = _e1192;
}
let _e1367 = phi_3827_;
let _e1369 = !(_e1256);
if (!(_e1332) && _e1369) {
let _e1375 = select(_e1367.member_5, _e1367.member_9, (_e1367.member_8 == 0f));
let _e1376 = (_e1201 + 1i);
let _e1378 = select(_e858, _e1376, (_e1376 < _e858));
let _e1384 = global_4.member[bitcast<u32>(select(0i, _e1378, (_e1378 > 0i)))];
let _e1386 = -((_e1384 * _e1375));
let _e1388 = select(-87f, _e1386, (_e1386 > -87f));
let _e1390 = select(88f, _e1388, (_e1388 < 88f));
let _e1392 = ((_e1390 * 1.442695f) + 0.5f);
let _e1394 = select(-127f, _e1392, (_e1392 > -127f));
let _e1396 = select(128f, _e1394, (_e1394 < 128f));
let _e1403 = select(0i, select(select(i32(_e1396), i32(-2147483648), (_e1396 < -2147483600f)), 2147483647i, (_e1396 > 2147483500f)), (_e1396 == _e1396));
let _e1407 = (_e1403 - select(0i, 1i, (_e1396 < f32(_e1403))));
let _e1408 = f32(_e1407);
let _e1412 = ((_e1390 - (_e1408 * 0.6933594f)) - (_e1408 * -2.1219444e-4f));
let _e1433 = (_e1201 + 2i);
let _e1435 = select(_e858, _e1433, (_e1433 < _e858));
let _e1441 = global_4.member[bitcast<u32>(select(0i, _e1435, (_e1435 > 0i)))];
let _e1443 = -((_e1441 * _e1375));
let _e1445 = select(-87f, _e1443, (_e1443 > -87f));
let _e1447 = select(88f, _e1445, (_e1445 < 88f));
let _e1449 = ((_e1447 * 1.442695f) + 0.5f);
let _e1451 = select(-127f, _e1449, (_e1449 > -127f));
let _e1453 = select(128f, _e1451, (_e1451 < 128f));
let _e1460 = select(0i, select(select(i32(_e1453), i32(-2147483648), (_e1453 < -2147483600f)), 2147483647i, (_e1453 > 2147483500f)), (_e1453 == _e1453));
let _e1464 = (_e1460 - select(0i, 1i, (_e1453 < f32(_e1460))));
let _e1465 = f32(_e1464);
let _e1469 = ((_e1447 - (_e1465 * 0.6933594f)) - (_e1465 * -2.1219444e-4f));
let _e1490 = (_e1201 + 3i);
let _e1492 = select(_e858, _e1490, (_e1490 < _e858));
let _e1498 = global_4.member[bitcast<u32>(select(0i, _e1492, (_e1492 > 0i)))];
let _e1500 = -((_e1498 * _e1375));
let _e1502 = select(-87f, _e1500, (_e1500 > -87f));
let _e1504 = select(88f, _e1502, (_e1502 < 88f));
let _e1506 = ((_e1504 * 1.442695f) + 0.5f);
let _e1508 = select(-127f, _e1506, (_e1506 > -127f));
let _e1510 = select(128f, _e1508, (_e1508 < 128f));
let _e1517 = select(0i, select(select(i32(_e1510), i32(-2147483648), (_e1510 < -2147483600f)), 2147483647i, (_e1510 > 2147483500f)), (_e1510 == _e1510));
let _e1521 = (_e1517 - select(0i, 1i, (_e1510 < f32(_e1517))));
let _e1522 = f32(_e1521);
let _e1526 = ((_e1504 - (_e1522 * 0.6933594f)) - (_e1522 * -2.1219444e-4f));
let _e1548 = select(((1f + (_e1412 * (1f + (_e1412 * (0.5f + (_e1412 * (0.16666667f + (_e1412 * (0.041666668f + (_e1412 * (0.008333334f + (_e1412 * (0.001388889f + (_e1412 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1407 + 127i)) << bitcast<u32>(23i)))), 1f, _e1212);
let _e1550 = (1f - (_e1331 * _e1548));
let _e1552 = (1f - _e1331);
let _e1558 = select(((1f + (_e1469 * (1f + (_e1469 * (0.5f + (_e1469 * (0.16666667f + (_e1469 * (0.041666668f + (_e1469 * (0.008333334f + (_e1469 * (0.001388889f + (_e1469 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1464 + 127i)) << bitcast<u32>(23i)))), 1f, _e1212);
let _e1560 = (1f - (_e1331 * _e1558));
let _e1567 = select(((1f + (_e1526 * (1f + (_e1526 * (0.5f + (_e1526 * (0.16666667f + (_e1526 * (0.041666668f + (_e1526 * (0.008333334f + (_e1526 * (0.001388889f + (_e1526 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1521 + 127i)) << bitcast<u32>(23i)))), 1f, _e1212);
let _e1569 = (1f - (_e1331 * _e1567));
phi_4158_ = type_20(_e1367.member, _e1367.member_1, _e1367.member_2, _e1367.member_3, _e1367.member_4, _e1367.member_5, _e1367.member_6, _e1367.member_7, _e1367.member_8, _e1367.member_9, _e1367.member_10, _e1367.member_11, vec3<f32>((_e1367.member_12.x + ((_e1367.member_2.x * select(1f, ((_e1552 * _e1548) / select(1e-9f, _e1550, (_e1550 > 1e-9f))), (_e1550 > 0f))) * _e1331)), (_e1367.member_12.y + ((_e1367.member_2.y * select(1f, ((_e1552 * _e1558) / select(1e-9f, _e1560, (_e1560 > 1e-9f))), (_e1560 > 0f))) * _e1331)), (_e1367.member_12.z + ((_e1367.member_2.z * select(1f, ((_e1552 * _e1567) / select(1e-9f, _e1569, (_e1569 > 1e-9f))), (_e1569 > 0f))) * _e1331))), _e1367.member_13, _e1367.member_14, _e1367.member_15);
} else {
phi_4158_ = _e1367;
}
let _e1612 = phi_4158_;
let _e1614 = (_e1612.member_8 + 1f);
let _e1630 = type_20(_e1612.member, _e1612.member_1, _e1612.member_2, _e1612.member_3, _e1612.member_4, _e1612.member_5, _e1612.member_6, _e1612.member_7, _e1614, _e1612.member_9, _e1612.member_10, _e1612.member_11, _e1612.member_12, _e1612.member_13, _e1612.member_14, _e1612.member_15);
let _e1633 = ((_e110.member_2 == 0u) && (_e1614 >= 2f));
if (_e1256 && _e1633) {
let _e1659 = (((_e1612.member_1.x * _e836) + (_e1612.member_1.y * _e837)) + (_e1612.member_1.z * _e838));
let _e1663 = (_e1612.member_1.x - (_e836 * _e1659));
let _e1664 = (_e1612.member_1.y - (_e837 * _e1659));
let _e1665 = (_e1612.member_1.z - (_e838 * _e1659));
let _e1670 = (((_e1663 * _e1663) + (_e1664 * _e1664)) + (_e1665 * _e1665));
let _e1673 = sqrt(select(0f, _e1670, (_e1670 > 0f)));
let _e1676 = (1f / select(1e-20f, _e1673, (_e1673 > 1e-20f)));
phi_4211_ = type_20(_e1630.member, vec3<f32>((_e1663 * _e1676), (_e1664 * _e1676), (_e1665 * _e1676)), _e1630.member_2, _e1630.member_3, _e1630.member_4, _e1630.member_5, _e1630.member_6, _e1630.member_7, _e1630.member_8, _e1630.member_9, _e1630.member_10, _e1630.member_11, _e1630.member_12, _e1630.member_13, _e1630.member_14, _e1630.member_15);
} else {
phi_4211_ = type_20(_e1630.member, vec3<f32>((_e1278 * _e1291), (_e1279 * _e1291), (_e1280 * _e1291)), _e1630.member_2, _e1630.member_3, _e1630.member_4, _e1630.member_5, _e1630.member_6, _e1630.member_7, _e1630.member_8, _e1630.member_9, _e1630.member_10, _e1630.member_11, _e1630.member_12, _e1630.member_13, _e1630.member_14, _e1630.member_15);
}
let _e1698 = phi_4211_;
if _e1256 {
phi_4225_ = _e1698;
} else {
let _e1699 = (1f - _e1331);
phi_4225_ = type_20(_e1698.member, _e1698.member_1, vec3<f32>((_e1698.member_2.x * _e1699), (_e1698.member_2.y * _e1699), (_e1698.member_2.z * _e1699)), _e1698.member_3, _e1698.member_4, _e1698.member_5, _e1698.member_6, _e1698.member_7, _e1698.member_8, _e1698.member_9, _e1698.member_10, _e1698.member_11, _e1698.member_12, _e1698.member_13, _e1698.member_14, _e1698.member_15);
}
let _e1727 = phi_4225_;
let _e1743 = type_20(_e1727.member, _e1727.member_1, _e1727.member_2, _e1727.member_3, _e1727.member_4, 0f, _e1727.member_6, _e1727.member_7, _e1727.member_8, _e1727.member_9, _e1727.member_10, _e1727.member_11, _e1727.member_12, _e1727.member_13, _e1727.member_14, _e1727.member_15);
let _e1750 = global_1.member.member_18.member.member;
let _e1764 = ((((_e1750.member.member * _e1727.member.x) + (_e1750.member.member_1 * _e1727.member.y)) + (_e1750.member.member_2 * _e1727.member.z)) + _e1750.member_1);
let _e1773 = -((((_e1750.member.member * _e1727.member_1.x) + (_e1750.member.member_1 * _e1727.member_1.y)) + (_e1750.member.member_2 * _e1727.member_1.z)));
let _e1775 = (_e1773 > 1e-9f);
let _e1779 = ((_e1764 / select(1e-9f, _e1773, _e1775)) - 0.015625f);
let _e1782 = select(1e30f, select(0f, _e1779, (_e1779 > 0f)), ((_e1764 > 0f) && _e1775));
let _e1787 = global_1.member.member_18.member_1.member;
let _e1798 = ((((_e1787.member.member * _e1727.member.x) + (_e1787.member.member_1 * _e1727.member.y)) + (_e1787.member.member_2 * _e1727.member.z)) + _e1787.member_1);
let _e1804 = -((((_e1787.member.member * _e1727.member_1.x) + (_e1787.member.member_1 * _e1727.member_1.y)) + (_e1787.member.member_2 * _e1727.member_1.z)));
let _e1806 = (_e1804 > 1e-9f);
let _e1810 = ((_e1798 / select(1e-9f, _e1804, _e1806)) - 0.015625f);
let _e1813 = select(1e30f, select(0f, _e1810, (_e1810 > 0f)), ((_e1798 > 0f) && _e1806));
let _e1817 = (_e1813 < _e1782);
let _e1819 = select(select(-2i, -3i, _e1817), -1i, ((_e1782 >= 1e30f) && (_e1813 >= 1e30f)));
let _e1820 = select(_e1782, _e1813, _e1817);
let _e1836 = type_20(_e1743.member, _e1743.member_1, _e1743.member_2, _e1743.member_3, _e1743.member_4, _e1743.member_5, _e1743.member_6, _e1743.member_7, _e1743.member_8, _e1743.member_9, _e1743.member_10, _e1743.member_11, _e1743.member_12, 0i, _e1743.member_14, _e1743.member_15);
let _e1852 = type_20(_e1836.member, _e1836.member_1, _e1836.member_2, _e1836.member_3, _e1836.member_4, _e1836.member_5, _e1836.member_6, _e1836.member_7, _e1836.member_8, _e1836.member_9, _e1836.member_10, _e1836.member_11, _e1836.member_12, _e1836.member_13, _e1819, _e1836.member_15);
let _e1868 = type_20(_e1852.member, _e1852.member_1, _e1852.member_2, _e1852.member_3, _e1852.member_4, _e1852.member_5, _e1852.member_6, _e1852.member_7, _e1852.member_8, _e1852.member_9, _e1852.member_10, _e1852.member_11, _e1852.member_12, _e1852.member_13, _e1852.member_14, _e1820);
let _e1870 = local_8;
let _e1872 = local_9;
let _e1875 = ((_e1328 & 2u) != 0u);
if (_e1633 && !(_e1875)) {
if (_e1819 == -1i) {
phi_4651_ = type_20(_e1868.member, _e1868.member_1, _e1868.member_2, _e1868.member_3, _e1868.member_4, _e1868.member_5, 1f, _e1868.member_7, _e1868.member_8, _e1868.member_9, _e1868.member_10, _e1868.member_11, _e1868.member_12, _e1868.member_13, _e1868.member_14, _e1868.member_15);
} else {
let _e1954 = type_20(vec3<f32>((_e1727.member.x + (_e1727.member_1.x * _e1820)), (_e1727.member.y + (_e1727.member_1.y * _e1820)), (_e1727.member.z + (_e1727.member_1.z * _e1820))), _e1868.member_1, _e1868.member_2, _e1868.member_3, _e1868.member_4, _e1868.member_5, _e1868.member_6, _e1868.member_7, _e1868.member_8, _e1868.member_9, _e1868.member_10, _e1868.member_11, _e1868.member_12, _e1868.member_13, _e1868.member_14, _e1868.member_15);
let _e1971 = type_20(_e1954.member, _e1954.member_1, _e1954.member_2, _e1954.member_3, _e1954.member_4, (0f + _e1820), _e1954.member_6, _e1954.member_7, _e1954.member_8, _e1954.member_9, _e1954.member_10, _e1954.member_11, _e1954.member_12, _e1954.member_13, _e1954.member_14, _e1954.member_15);
let _e1988 = type_20(_e1971.member, _e1971.member_1, _e1971.member_2, _e1971.member_3, _e1971.member_4, _e1971.member_5, _e1971.member_6, _e1971.member_7, _e1971.member_8, _e1971.member_9, _e1971.member_10, _e1971.member_11, _e1971.member_12, _e1971.member_13, _e1971.member_14, (_e1820 - _e1820));
let _e2009 = type_20(_e1988.member, _e1988.member_1, _e1988.member_2, _e1988.member_3, _e1988.member_4, _e1988.member_5, _e1988.member_6, _e1988.member_7, _e1988.member_8, _e1988.member_9, (_e1727.member_10 + select(0f, _e1820, (_e1727.member_8 == 0f))), _e1988.member_11, _e1988.member_12, _e1988.member_13, _e1988.member_14, _e1988.member_15);
phi_4651_ = type_20(_e2009.member, _e2009.member_1, _e2009.member_2, _e2009.member_3, _e2009.member_4, _e2009.member_5, 3f, _e2009.member_7, _e2009.member_8, _e2009.member_9, _e2009.member_10, _e2009.member_11, _e2009.member_12, _e2009.member_13, _e2009.member_14, _e2009.member_15);
}
let _e2043 = phi_4651_;
phi_4672_ = _e2043;
} else {
let _e1882 = global_1.member.member_5;
if ((!(_e1633) && (_e1727.member_8 >= f32(bitcast<i32>(_e1882)))) && (select(_e1872, _e1870, _e1256) != 16i)) {
phi_4671_ = type_20(_e1868.member, _e1868.member_1, _e1868.member_2, _e1868.member_3, _e1868.member_4, _e1868.member_5, 2f, _e1868.member_7, _e1868.member_8, _e1868.member_9, _e1868.member_10, _e1868.member_11, _e1868.member_12, _e1868.member_13, _e1868.member_14, _e1868.member_15);
} else {
if _e1875 {
phi_4670_ = type_20(_e1868.member, _e1868.member_1, _e1868.member_2, _e1868.member_3, _e1868.member_4, _e1868.member_5, 4f, _e1868.member_7, _e1868.member_8, _e1868.member_9, _e1868.member_10, _e1868.member_11, _e1868.member_12, _e1868.member_13, _e1868.member_14, _e1868.member_15);
} else {
phi_4670_ = _e1868;
}
let _e1906 = phi_4670_;
phi_4671_ = _e1906;
}
let _e1924 = phi_4671_;
phi_4672_ = _e1924;
}
let _e2045 = phi_4672_;
phi_4677_ = _e2045;
phi_4678_ = _e2045;
phi_4679_ = _e1369;
}
let _e2172 = phi_4677_;
let _e2174 = phi_4678_;
let _e2176 = phi_4679_;
if _e2176 {
phi_4683_ = _e2172;
} else {
phi_4683_ = _e2174;
}
let _e2178 = phi_4683_;
phi_4685_ = _e2178;
phi_4686_ = select(_e487, _e883, _e2176);
}
let _e2506 = phi_4685_;
let _e2508 = phi_4686_;
phi_4687_ = _e2506;
phi_4688_ = _e2508;
}
let _e2989 = phi_4687_;
let _e2991 = phi_4688_;
phi_4689_ = _e2989;
phi_4690_ = _e2991;
}
let _e3384 = phi_4689_;
let _e3386 = phi_4690_;
phi_786_ = _e3384;
phi_789_ = (_e485 + 1i);
phi_791_ = _e3386;
} else {
phi_786_ = type_20();
phi_789_ = i32();
phi_791_ = i32();
}
let _e3388 = phi_786_;
let _e3390 = phi_789_;
let _e3392 = phi_791_;
continue;
continuing {
phi_785_ = _e3388;
phi_788_ = _e3390;
phi_790_ = _e3392;
break if !(_e491);
}
}
let _e3395 = local_15;
if (_e3395 == 0i) {
phi_4696_ = 16i;
} else {
let _e3398 = local_16;
phi_4696_ = -(_e3398);
}
let _e3401 = phi_4696_;
let _e3403 = local_17;
let _e3407 = local_18;
let _e3411 = local_19;
let _e3415 = local_20;
let _e3419 = local_21;
let _e3423 = local_22;
let _e3427 = local_23;
let _e3431 = local_24;
let _e3435 = local_25;
let _e3439 = local_26;
let _e3443 = local_27;
let _e3447 = local_28;
let _e3451 = local_29;
let _e3455 = local_30;
let _e3459 = local_31;
let _e3463 = local_32;
let _e3467 = local_33;
let _e3470 = local_34;
let _e3473 = local_35;
let _e3476 = local_36;
let _e3479 = local_37;
let _e3483 = local_38;
let _e3487 = local_39;
let _e3491 = local_40;
let _e3495 = local_41;
let _e3499 = local_42;
global_5.member[_e119] = _e3403.member.x;
global_5.member[_e131] = _e3407.member.y;
global_5.member[_e142] = _e3411.member.z;
global_5.member[_e153] = _e3415.member_1.x;
global_5.member[_e164] = _e3419.member_1.y;
global_5.member[_e175] = _e3423.member_1.z;
global_5.member[_e186] = _e3427.member_2.x;
global_5.member[_e197] = _e3431.member_2.y;
global_5.member[_e208] = _e3435.member_2.z;
global_5.member[_e219] = _e3439.member_3.x;
global_5.member[_e230] = _e3443.member_3.y;
global_5.member[_e241] = _e3447.member_3.z;
global_5.member[_e252] = _e3451.member_4.x;
global_5.member[_e263] = _e3455.member_4.y;
global_5.member[_e274] = _e3459.member_4.z;
global_5.member[_e285] = _e3463.member_5;
let _e3536 = local_43;
global_5.member[_e296] = _e3536;
global_5.member[_e307] = f32(_e3401);
global_5.member[_e318] = _e3467.member_8;
global_5.member[_e329] = _e3470.member_9;
global_5.member[_e340] = _e3473.member_10;
global_5.member[_e351] = _e3476.member_11;
global_5.member[_e362] = _e3479.member_12.x;
global_5.member[_e373] = _e3483.member_12.y;
global_5.member[_e384] = _e3487.member_12.z;
global_5.member[_e395] = f32(_e3491.member_13);
global_5.member[_e406] = f32(_e3495.member_14);
global_5.member[_e417] = _e3499.member_15;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
