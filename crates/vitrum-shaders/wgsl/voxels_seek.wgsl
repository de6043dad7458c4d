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
struct type_19 {
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
member_13: vec3<f32>,
member_14: vec3<f32>,
member_15: vec3<f32>,
member_16: vec3<f32>,
member_17: vec3<f32>,
member_18: i32,
member_19: i32,
member_20: i32,
member_21: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(2)
var<storage> global_3: type_16;
@group(0) @binding(4)
var<storage, read_write> global_4: type_16;
fn function_() {
var phi_975_: u32;
var phi_1045_: type_19;
var phi_1048_: i32;
var phi_2012_: type_19;
var phi_2014_: type_19;
var phi_1343_: i32;
var phi_1710_: type_19;
var phi_1711_: type_19;
var phi_2015_: type_19;
var phi_1046_: type_19;
var phi_1049_: i32;
var local: type_19;
var local_1: type_19;
var local_2: type_19;
var local_3: type_19;
var local_4: type_19;
var local_5: type_19;
var local_6: type_19;
var local_7: type_19;
var local_8: type_19;
var local_9: type_19;
var local_10: type_19;
var local_11: type_19;
var local_12: type_19;
var local_13: type_19;
var local_14: type_19;
var local_15: type_19;
var local_16: type_19;
var local_17: type_19;
var local_18: type_19;
var local_19: type_19;
var local_20: type_19;
var local_21: type_19;
var local_22: type_19;
var local_23: type_19;
var local_24: type_19;
var local_25: type_19;
var local_26: type_19;
var local_27: type_19;
var local_28: type_19;
var local_29: type_19;
var local_30: type_19;
var local_31: type_19;
var local_32: type_19;
var local_33: type_19;
var local_34: type_19;
var local_35: type_19;
var local_36: type_19;
var local_37: type_19;
var local_38: type_19;
var local_39: type_19;
var local_40: type_19;
var local_41: type_19;
var local_42: type_19;
var local_43: f32;
let _e77 = global;
let _e86 = global_1.member.member;
if (_e77.x < _e86.member) {
if (_e77.y < _e86.member_1) {
let _e93 = (_e86.member * _e86.member_1);
let _e95 = ((_e77.y * _e86.member) + _e77.x);
let _e96 = bitcast<i32>(_e95);
let _e98 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e100 = select(_e98, _e96, (_e96 < _e98));
let _e106 = global_4.member[bitcast<u32>(select(0i, _e100, (_e100 > 0i)))];
let _e107 = (_e93 + _e95);
let _e108 = bitcast<i32>(_e107);
let _e110 = select(_e98, _e108, (_e108 < _e98));
let _e116 = global_4.member[bitcast<u32>(select(0i, _e110, (_e110 > 0i)))];
let _e118 = ((2u * _e93) + _e95);
let _e119 = bitcast<i32>(_e118);
let _e121 = select(_e98, _e119, (_e119 < _e98));
let _e127 = global_4.member[bitcast<u32>(select(0i, _e121, (_e121 > 0i)))];
let _e129 = ((3u * _e93) + _e95);
let _e130 = bitcast<i32>(_e129);
let _e132 = select(_e98, _e130, (_e130 < _e98));
let _e138 = global_4.member[bitcast<u32>(select(0i, _e132, (_e132 > 0i)))];
let _e140 = ((4u * _e93) + _e95);
let _e141 = bitcast<i32>(_e140);
let _e143 = select(_e98, _e141, (_e141 < _e98));
let _e149 = global_4.member[bitcast<u32>(select(0i, _e143, (_e143 > 0i)))];
let _e151 = ((5u * _e93) + _e95);
let _e152 = bitcast<i32>(_e151);
let _e154 = select(_e98, _e152, (_e152 < _e98));
let _e160 = global_4.member[bitcast<u32>(select(0i, _e154, (_e154 > 0i)))];
let _e162 = ((6u * _e93) + _e95);
let _e163 = bitcast<i32>(_e162);
let _e165 = select(_e98, _e163, (_e163 < _e98));
let _e171 = global_4.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e173 = ((7u * _e93) + _e95);
let _e174 = bitcast<i32>(_e173);
let _e176 = select(_e98, _e174, (_e174 < _e98));
let _e182 = global_4.member[bitcast<u32>(select(0i, _e176, (_e176 > 0i)))];
let _e184 = ((8u * _e93) + _e95);
let _e185 = bitcast<i32>(_e184);
let _e187 = select(_e98, _e185, (_e185 < _e98));
let _e193 = global_4.member[bitcast<u32>(select(0i, _e187, (_e187 > 0i)))];
let _e195 = ((9u * _e93) + _e95);
let _e196 = bitcast<i32>(_e195);
let _e198 = select(_e98, _e196, (_e196 < _e98));
let _e204 = global_4.member[bitcast<u32>(select(0i, _e198, (_e198 > 0i)))];
let _e206 = ((10u * _e93) + _e95);
let _e207 = bitcast<i32>(_e206);
let _e209 = select(_e98, _e207, (_e207 < _e98));
let _e215 = global_4.member[bitcast<u32>(select(0i, _e209, (_e209 > 0i)))];
let _e217 = ((11u * _e93) + _e95);
let _e218 = bitcast<i32>(_e217);
let _e220 = select(_e98, _e218, (_e218 < _e98));
let _e226 = global_4.member[bitcast<u32>(select(0i, _e220, (_e220 > 0i)))];
let _e228 = ((12u * _e93) + _e95);
let _e229 = bitcast<i32>(_e228);
let _e231 = select(_e98, _e229, (_e229 < _e98));
let _e237 = global_4.member[bitcast<u32>(select(0i, _e231, (_e231 > 0i)))];
let _e239 = ((13u * _e93) + _e95);
let _e240 = bitcast<i32>(_e239);
let _e242 = select(_e98, _e240, (_e240 < _e98));
let _e248 = global_4.member[bitcast<u32>(select(0i, _e242, (_e242 > 0i)))];
let _e250 = ((14u * _e93) + _e95);
let _e251 = bitcast<i32>(_e250);
let _e253 = select(_e98, _e251, (_e251 < _e98));
let _e259 = global_4.member[bitcast<u32>(select(0i, _e253, (_e253 > 0i)))];
let _e261 = ((15u * _e93) + _e95);
let _e262 = bitcast<i32>(_e261);
let _e264 = select(_e98, _e262, (_e262 < _e98));
let _e270 = global_4.member[bitcast<u32>(select(0i, _e264, (_e264 > 0i)))];
let _e272 = ((16u * _e93) + _e95);
let _e273 = bitcast<i32>(_e272);
let _e275 = select(_e98, _e273, (_e273 < _e98));
let _e281 = global_4.member[bitcast<u32>(select(0i, _e275, (_e275 > 0i)))];
let _e283 = ((17u * _e93) + _e95);
let _e284 = bitcast<i32>(_e283);
let _e286 = select(_e98, _e284, (_e284 < _e98));
let _e292 = global_4.member[bitcast<u32>(select(0i, _e286, (_e286 > 0i)))];
let _e294 = ((18u * _e93) + _e95);
let _e295 = bitcast<i32>(_e294);
let _e297 = select(_e98, _e295, (_e295 < _e98));
let _e303 = global_4.member[bitcast<u32>(select(0i, _e297, (_e297 > 0i)))];
let _e305 = ((19u * _e93) + _e95);
let _e306 = bitcast<i32>(_e305);
let _e308 = select(_e98, _e306, (_e306 < _e98));
let _e314 = global_4.member[bitcast<u32>(select(0i, _e308, (_e308 > 0i)))];
let _e316 = ((20u * _e93) + _e95);
let _e317 = bitcast<i32>(_e316);
let _e319 = select(_e98, _e317, (_e317 < _e98));
let _e325 = global_4.member[bitcast<u32>(select(0i, _e319, (_e319 > 0i)))];
let _e327 = ((21u * _e93) + _e95);
let _e328 = bitcast<i32>(_e327);
let _e330 = select(_e98, _e328, (_e328 < _e98));
let _e336 = global_4.member[bitcast<u32>(select(0i, _e330, (_e330 > 0i)))];
let _e338 = ((22u * _e93) + _e95);
let _e339 = bitcast<i32>(_e338);
let _e341 = select(_e98, _e339, (_e339 < _e98));
let _e347 = global_4.member[bitcast<u32>(select(0i, _e341, (_e341 > 0i)))];
let _e349 = ((23u * _e93) + _e95);
let _e350 = bitcast<i32>(_e349);
let _e352 = select(_e98, _e350, (_e350 < _e98));
let _e358 = global_4.member[bitcast<u32>(select(0i, _e352, (_e352 > 0i)))];
let _e360 = ((24u * _e93) + _e95);
let _e361 = bitcast<i32>(_e360);
let _e363 = select(_e98, _e361, (_e361 < _e98));
let _e369 = global_4.member[bitcast<u32>(select(0i, _e363, (_e363 > 0i)))];
let _e371 = ((25u * _e93) + _e95);
let _e372 = bitcast<i32>(_e371);
let _e374 = select(_e98, _e372, (_e372 < _e98));
let _e380 = global_4.member[bitcast<u32>(select(0i, _e374, (_e374 > 0i)))];
let _e382 = ((26u * _e93) + _e95);
let _e383 = bitcast<i32>(_e382);
let _e385 = select(_e98, _e383, (_e383 < _e98));
let _e391 = global_4.member[bitcast<u32>(select(0i, _e385, (_e385 > 0i)))];
let _e393 = ((27u * _e93) + _e95);
let _e394 = bitcast<i32>(_e393);
let _e396 = select(_e98, _e394, (_e394 < _e98));
let _e402 = global_4.member[bitcast<u32>(select(0i, _e396, (_e396 > 0i)))];
let _e404 = ((28u * _e93) + _e95);
let _e405 = bitcast<i32>(_e404);
let _e407 = select(_e98, _e405, (_e405 < _e98));
let _e413 = global_4.member[bitcast<u32>(select(0i, _e407, (_e407 > 0i)))];
let _e415 = ((29u * _e93) + _e95);
let _e416 = bitcast<i32>(_e415);
let _e418 = select(_e98, _e416, (_e416 < _e98));
let _e424 = global_4.member[bitcast<u32>(select(0i, _e418, (_e418 > 0i)))];
let _e426 = ((30u * _e93) + _e95);
let _e427 = bitcast<i32>(_e426);
let _e429 = select(_e98, _e427, (_e427 < _e98));
let _e435 = global_4.member[bitcast<u32>(select(0i, _e429, (_e429 > 0i)))];
let _e437 = ((31u * _e93) + _e95);
let _e438 = bitcast<i32>(_e437);
let _e440 = select(_e98, _e438, (_e438 < _e98));
let _e446 = global_4.member[bitcast<u32>(select(0i, _e440, (_e440 > 0i)))];
let _e448 = ((32u * _e93) + _e95);
let _e449 = bitcast<i32>(_e448);
let _e451 = select(_e98, _e449, (_e449 < _e98));
let _e457 = global_4.member[bitcast<u32>(select(0i, _e451, (_e451 > 0i)))];
let _e459 = ((33u * _e93) + _e95);
let _e460 = bitcast<i32>(_e459);
let _e462 = select(_e98, _e460, (_e460 < _e98));
let _e468 = global_4.member[bitcast<u32>(select(0i, _e462, (_e462 > 0i)))];
let _e470 = ((34u * _e93) + _e95);
let _e471 = bitcast<i32>(_e470);
let _e473 = select(_e98, _e471, (_e471 < _e98));
let _e479 = global_4.member[bitcast<u32>(select(0i, _e473, (_e473 > 0i)))];
let _e481 = ((35u * _e93) + _e95);
let _e482 = bitcast<i32>(_e481);
let _e484 = select(_e98, _e482, (_e482 < _e98));
let _e490 = global_4.member[bitcast<u32>(select(0i, _e484, (_e484 > 0i)))];
let _e492 = ((36u * _e93) + _e95);
let _e493 = bitcast<i32>(_e492);
let _e495 = select(_e98, _e493, (_e493 < _e98));
let _e501 = global_4.member[bitcast<u32>(select(0i, _e495, (_e495 > 0i)))];
let _e503 = ((37u * _e93) + _e95);
let _e504 = bitcast<i32>(_e503);
let _e506 = select(_e98, _e504, (_e504 < _e98));
let _e512 = global_4.member[bitcast<u32>(select(0i, _e506, (_e506 > 0i)))];
let _e514 = ((38u * _e93) + _e95);
let _e515 = bitcast<i32>(_e514);
let _e517 = select(_e98, _e515, (_e515 < _e98));
let _e523 = global_4.member[bitcast<u32>(select(0i, _e517, (_e517 > 0i)))];
let _e525 = ((39u * _e93) + _e95);
let _e526 = bitcast<i32>(_e525);
let _e528 = select(_e98, _e526, (_e526 < _e98));
let _e534 = global_4.member[bitcast<u32>(select(0i, _e528, (_e528 > 0i)))];
let _e536 = ((40u * _e93) + _e95);
let _e537 = bitcast<i32>(_e536);
let _e539 = select(_e98, _e537, (_e537 < _e98));
let _e545 = global_4.member[bitcast<u32>(select(0i, _e539, (_e539 > 0i)))];
let _e547 = ((41u * _e93) + _e95);
let _e548 = bitcast<i32>(_e547);
let _e550 = select(_e98, _e548, (_e548 < _e98));
let _e556 = global_4.member[bitcast<u32>(select(0i, _e550, (_e550 > 0i)))];
let _e558 = ((42u * _e93) + _e95);
let _e559 = bitcast<i32>(_e558);
let _e561 = select(_e98, _e559, (_e559 < _e98));
let _e567 = global_4.member[bitcast<u32>(select(0i, _e561, (_e561 > 0i)))];
let _e569 = ((43u * _e93) + _e95);
let _e570 = bitcast<i32>(_e569);
let _e572 = select(_e98, _e570, (_e570 < _e98));
let _e578 = global_4.member[bitcast<u32>(select(0i, _e572, (_e572 > 0i)))];
if (_e281 == 4f) {
phi_975_ = 3u;
} else {
phi_975_ = select(0u, 1u, (_e281 == 0f));
}
let _e583 = phi_975_;
if (_e583 > 1u) {
let _e626 = bitcast<i32>(arrayLength((&global_2.member)));
phi_1045_ = type_19(vec3<f32>(_e106, _e116, _e127), vec3<f32>(_e138, _e149, _e160), vec3<f32>(_e171, _e182, _e193), vec3<f32>(_e204, _e215, _e226), vec3<f32>(_e237, _e248, _e259), _e270, _e281, select(0i, select(select(i32(_e292), i32(-2147483648), (_e292 < -2147483600f)), 2147483647i, (_e292 > 2147483500f)), (_e292 == _e292)), _e303, _e314, _e325, _e336, vec3<f32>(_e347, _e358, _e369), vec3<f32>(_e380, _e391, _e402), vec3<f32>(_e413, _e424, _e435), vec3<f32>(_e446, _e457, _e468), vec3<f32>(_e479, _e490, _e501), vec3<f32>(_e512, _e523, _e534), select(0i, select(select(i32(_e545), i32(-2147483648), (_e545 < -2147483600f)), 2147483647i, (_e545 > 2147483500f)), (_e545 == _e545)), select(0i, select(select(i32(_e556), i32(-2147483648), (_e556 < -2147483600f)), 2147483647i, (_e556 > 2147483500f)), (_e556 == _e556)), select(0i, select(select(i32(_e567), i32(-2147483648), (_e567 < -2147483600f)), 2147483647i, (_e567 > 2147483500f)), (_e567 == _e567)), _e578);
phi_1048_ = 0i;
loop {
let _e629 = phi_1045_;
let _e631 = phi_1048_;
local = _e629;
local_1 = _e629;
local_2 = _e629;
local_3 = _e629;
local_4 = _e629;
local_5 = _e629;
local_6 = _e629;
local_7 = _e629;
local_8 = _e629;
local_9 = _e629;
local_10 = _e629;
local_11 = _e629;
local_12 = _e629;
local_13 = _e629;
local_14 = _e629;
local_15 = _e629;
local_16 = _e629;
local_17 = _e629;
local_18 = _e629;
local_19 = _e629;
local_20 = _e629;
local_21 = _e629;
local_22 = _e629;
local_23 = _e629;
local_24 = _e629;
local_25 = _e629;
local_26 = _e629;
local_27 = _e629;
local_28 = _e629;
local_29 = _e629;
local_30 = _e629;
local_31 = _e629;
local_32 = _e629;
local_33 = _e629;
local_34 = _e629;
local_35 = _e629;
local_36 = _e629;
local_37 = _e629;
local_38 = _e629;
local_39 = _e629;
local_40 = _e629;
local_41 = _e629;
local_42 = _e629;
let _e635 = ((_e631 < 1024i) && (_e629.member_6 == 4f));
local_43 = _e629.member_6;
if _e635 {
if (_e629.member_19 < (_e626 / 8i)) {
let _e835 = (_e629.member_19 * 8i);
let _e843 = (1f / select(_e629.member_1.x, select(1e-12f, -1e-12f, (_e629.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e629.member_1.x) & 2147483647u)) < 1e-12f)));
let _e851 = (1f / select(_e629.member_1.y, select(1e-12f, -1e-12f, (_e629.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e629.member_1.y) & 2147483647u)) < 1e-12f)));
let _e859 = (1f / select(_e629.member_1.z, select(1e-12f, -1e-12f, (_e629.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e629.member_1.z) & 2147483647u)) < 1e-12f)));
let _e861 = (_e626 - 1i);
let _e863 = select(_e861, _e835, (_e835 < _e861));
let _e869 = global_2.member[bitcast<u32>(select(0i, _e863, (_e863 > 0i)))];
let _e870 = (_e835 + 1i);
let _e872 = select(_e861, _e870, (_e870 < _e861));
let _e878 = global_2.member[bitcast<u32>(select(0i, _e872, (_e872 > 0i)))];
let _e879 = (_e835 + 2i);
let _e881 = select(_e861, _e879, (_e879 < _e861));
let _e887 = global_2.member[bitcast<u32>(select(0i, _e881, (_e881 > 0i)))];
let _e888 = (_e835 + 3i);
let _e890 = select(_e861, _e888, (_e888 < _e861));
let _e896 = global_2.member[bitcast<u32>(select(0i, _e890, (_e890 > 0i)))];
let _e897 = (_e835 + 4i);
let _e899 = select(_e861, _e897, (_e897 < _e861));
let _e905 = global_2.member[bitcast<u32>(select(0i, _e899, (_e899 > 0i)))];
let _e906 = (_e835 + 5i);
let _e908 = select(_e861, _e906, (_e906 < _e861));
let _e914 = global_2.member[bitcast<u32>(select(0i, _e908, (_e908 > 0i)))];
let _e917 = ((_e869 - _e629.member.x) * _e843);
let _e919 = ((_e896 - _e629.member.x) * _e843);
let _e922 = ((_e878 - _e629.member.y) * _e851);
let _e924 = ((_e905 - _e629.member.y) * _e851);
let _e927 = ((_e887 - _e629.member.z) * _e859);
let _e929 = ((_e914 - _e629.member.z) * _e859);
let _e931 = select(_e919, _e917, (_e917 < _e919));
let _e933 = select(_e924, _e922, (_e922 < _e924));
let _e935 = select(_e933, _e931, (_e931 > _e933));
let _e937 = select(_e929, _e927, (_e927 < _e929));
let _e941 = select(_e919, _e917, (_e917 > _e919));
let _e943 = select(_e924, _e922, (_e922 > _e924));
let _e945 = select(_e943, _e941, (_e941 < _e943));
let _e947 = select(_e929, _e927, (_e927 > _e929));
let _e949 = select(_e947, _e945, (_e945 < _e947));
let _e954 = ((select(_e937, _e935, (_e935 > _e937)) <= select(_e629.member_21, _e949, (_e949 < _e629.member_21))) && (_e949 >= 0f));
let _e955 = (_e835 + 6i);
let _e957 = select(_e861, _e955, (_e955 < _e861));
let _e963 = global_2.member[bitcast<u32>(select(0i, _e957, (_e957 > 0i)))];
if _e954 {
phi_1343_ = (_e629.member_19 + 1i);
} else {
let _e971 = (_e835 + 7i);
let _e973 = select(_e861, _e971, (_e971 < _e861));
let _e979 = global_2.member[bitcast<u32>(select(0i, _e973, (_e973 > 0i)))];
phi_1343_ = select(0i, select(select(i32(_e979), i32(-2147483648), (_e979 < -2147483600f)), 2147483647i, (_e979 > 2147483500f)), (_e979 == _e979));
}
let _e989 = phi_1343_;
let _e1011 = type_19(_e629.member, _e629.member_1, _e629.member_2, _e629.member_3, _e629.member_4, _e629.member_5, _e629.member_6, _e629.member_7, _e629.member_8, _e629.member_9, _e629.member_10, _e629.member_11, _e629.member_12, _e629.member_13, _e629.member_14, _e629.member_15, _e629.member_16, _e629.member_17, _e629.member_18, _e989, _e629.member_20, _e629.member_21);
let _e1012 = select(-1i, select(0i, select(select(i32(_e963), i32(-2147483648), (_e963 < -2147483600f)), 2147483647i, (_e963 > 2147483500f)), (_e963 == _e963)), _e954);
if (_e1012 >= 0i) {
let _e1018 = bitcast<f32>((bitcast<u32>(_e629.member_1.x) & 2147483647u));
let _e1022 = bitcast<f32>((bitcast<u32>(_e629.member_1.y) & 2147483647u));
let _e1026 = bitcast<f32>((bitcast<u32>(_e629.member_1.z) & 2147483647u));
let _e1029 = ((_e1018 >= _e1022) && (_e1018 >= _e1026));
let _e1032 = (!(_e1029) && (_e1022 >= _e1026));
let _e1039 = (1f / select(select(_e629.member_1.z, _e629.member_1.y, _e1032), _e629.member_1.x, _e1029));
let _e1040 = (select(select(_e629.member_1.x, _e629.member_1.z, _e1032), _e629.member_1.y, _e1029) * _e1039);
let _e1041 = (select(select(_e629.member_1.y, _e629.member_1.x, _e1032), _e629.member_1.z, _e1029) * _e1039);
let _e1042 = (_e1012 * 19i);
let _e1044 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e1046 = select(_e1044, _e1042, (_e1042 < _e1044));
let _e1052 = global_3.member[bitcast<u32>(select(0i, _e1046, (_e1046 > 0i)))];
let _e1053 = (_e1042 + 1i);
let _e1055 = select(_e1044, _e1053, (_e1053 < _e1044));
let _e1061 = global_3.member[bitcast<u32>(select(0i, _e1055, (_e1055 > 0i)))];
let _e1062 = (_e1042 + 2i);
let _e1064 = select(_e1044, _e1062, (_e1062 < _e1044));
let _e1070 = global_3.member[bitcast<u32>(select(0i, _e1064, (_e1064 > 0i)))];
let _e1071 = (_e1052 - _e629.member.x);
let _e1072 = (_e1061 - _e629.member.y);
let _e1073 = (_e1070 - _e629.member.z);
let _e1079 = select(select(_e1073, _e1072, _e1032), _e1071, _e1029);
let _e1081 = (select(select(_e1071, _e1073, _e1032), _e1072, _e1029) - (_e1040 * _e1079));
let _e1083 = (select(select(_e1072, _e1071, _e1032), _e1073, _e1029) - (_e1041 * _e1079));
let _e1085 = (_e1042 + 3i);
let _e1087 = select(_e1044, _e1085, (_e1085 < _e1044));
let _e1093 = global_3.member[bitcast<u32>(select(0i, _e1087, (_e1087 > 0i)))];
let _e1094 = (_e1042 + 4i);
let _e1096 = select(_e1044, _e1094, (_e1094 < _e1044));
let _e1102 = global_3.member[bitcast<u32>(select(0i, _e1096, (_e1096 > 0i)))];
let _e1103 = (_e1042 + 5i);
let _e1105 = select(_e1044, _e1103, (_e1103 < _e1044));
let _e1111 = global_3.member[bitcast<u32>(select(0i, _e1105, (_e1105 > 0i)))];
let _e1112 = (_e1093 - _e629.member.x);
let _e1113 = (_e1102 - _e629.member.y);
let _e1114 = (_e1111 - _e629.member.z);
let _e1120 = select(select(_e1114, _e1113, _e1032), _e1112, _e1029);
let _e1122 = (select(select(_e1112, _e1114, _e1032), _e1113, _e1029) - (_e1040 * _e1120));
let _e1124 = (select(select(_e1113, _e1112, _e1032), _e1114, _e1029) - (_e1041 * _e1120));
let _e1126 = (_e1042 + 6i);
let _e1128 = select(_e1044, _e1126, (_e1126 < _e1044));
let _e1134 = global_3.member[bitcast<u32>(select(0i, _e1128, (_e1128 > 0i)))];
let _e1135 = (_e1042 + 7i);
let _e1137 = select(_e1044, _e1135, (_e1135 < _e1044));
let _e1143 = global_3.member[bitcast<u32>(select(0i, _e1137, (_e1137 > 0i)))];
let _e1144 = (_e1042 + 8i);
let _e1146 = select(_e1044, _e1144, (_e1144 < _e1044));
let _e1152 = global_3.member[bitcast<u32>(select(0i, _e1146, (_e1146 > 0i)))];
let _e1153 = (_e1134 - _e629.member.x);
let _e1154 = (_e1143 - _e629.member.y);
let _e1155 = (_e1152 - _e629.member.z);
let _e1161 = select(select(_e1155, _e1154, _e1032), _e1153, _e1029);
let _e1163 = (select(select(_e1153, _e1155, _e1032), _e1154, _e1029) - (_e1040 * _e1161));
let _e1165 = (select(select(_e1154, _e1153, _e1032), _e1155, _e1029) - (_e1041 * _e1161));
let _e1169 = ((_e1163 * _e1124) - (_e1165 * _e1122));
let _e1172 = ((_e1081 * _e1165) - (_e1083 * _e1163));
let _e1175 = ((_e1122 * _e1083) - (_e1124 * _e1081));
let _e1177 = ((_e1169 + _e1172) + _e1175);
let _e1191 = (!(((((_e1169 < 0f) || (_e1172 < 0f)) || (_e1175 < 0f)) && (((_e1169 > 0f) || (_e1172 > 0f)) || (_e1175 > 0f)))) && (_e1177 != 0f));
let _e1199 = select(1e30f, ((((_e1169 * (_e1079 * _e1039)) + (_e1172 * (_e1120 * _e1039))) + (_e1175 * (_e1161 * _e1039))) / select(1f, _e1177, _e1191)), _e1191);
let _e1201 = select(1e30f, _e1199, (_e1199 > 1e-3f));
if (_e1201 < _e629.member_21) {
let _e1224 = type_19(_e1011.member, _e1011.member_1, _e1011.member_2, _e1011.member_3, _e1011.member_4, _e1011.member_5, _e1011.member_6, _e1011.member_7, _e1011.member_8, _e1011.member_9, _e1011.member_10, _e1011.member_11, _e1011.member_12, _e1011.member_13, _e1011.member_14, _e1011.member_15, _e1011.member_16, _e1011.member_17, _e1011.member_18, _e1011.member_19, _e1011.member_20, _e1201);
phi_1710_ = type_19(_e1224.member, _e1224.member_1, _e1224.member_2, _e1224.member_3, _e1224.member_4, _e1224.member_5, _e1224.member_6, _e1224.member_7, _e1224.member_8, _e1224.member_9, _e1224.member_10, _e1224.member_11, _e1224.member_12, _e1224.member_13, _e1224.member_14, _e1224.member_15, _e1224.member_16, _e1224.member_17, _e1224.member_18, _e1224.member_19, _e1012, _e1224.member_21);
} else {
phi_1710_ = _e1011;
}
let _e1248 = phi_1710_;
phi_1711_ = _e1248;
} else {
phi_1711_ = _e1011;
}
let _e1250 = phi_1711_;
phi_2015_ = _e1250;
} else {
if ((_e86.member_2 == 0u) && (_e629.member_8 >= 2f)) {
if (_e629.member_20 == -1i) {
phi_2012_ = type_19(_e629.member, _e629.member_1, _e629.member_2, _e629.member_3, _e629.member_4, _e629.member_5, 1f, _e629.member_7, _e629.member_8, _e629.member_9, _e629.member_10, _e629.member_11, _e629.member_12, _e629.member_13, _e629.member_14, _e629.member_15, _e629.member_16, _e629.member_17, _e629.member_18, _e629.member_19, _e629.member_20, _e629.member_21);
} else {
let _e706 = type_19(vec3<f32>((_e629.member.x + (_e629.member_1.x * _e629.member_21)), (_e629.member.y + (_e629.member_1.y * _e629.member_21)), (_e629.member.z + (_e629.member_1.z * _e629.member_21))), _e629.member_1, _e629.member_2, _e629.member_3, _e629.member_4, _e629.member_5, _e629.member_6, _e629.member_7, _e629.member_8, _e629.member_9, _e629.member_10, _e629.member_11, _e629.member_12, _e629.member_13, _e629.member_14, _e629.member_15, _e629.member_16, _e629.member_17, _e629.member_18, _e629.member_19, _e629.member_20, _e629.member_21);
let _e730 = type_19(_e706.member, _e706.member_1, _e706.member_2, _e706.member_3, _e706.member_4, (_e629.member_5 + _e629.member_21), _e706.member_6, _e706.member_7, _e706.member_8, _e706.member_9, _e706.member_10, _e706.member_11, _e706.member_12, _e706.member_13, _e706.member_14, _e706.member_15, _e706.member_16, _e706.member_17, _e706.member_18, _e706.member_19, _e706.member_20, _e706.member_21);
let _e753 = type_19(_e730.member, _e730.member_1, _e730.member_2, _e730.member_3, _e730.member_4, _e730.member_5, _e730.member_6, _e730.member_7, _e730.member_8, _e730.member_9, _e730.member_10, _e730.member_11, _e730.member_12, _e730.member_13, _e730.member_14, _e730.member_15, _e730.member_16, _e730.member_17, _e730.member_18, _e730.member_19, _e730.member_20, (_e629.member_21 - _e629.member_21));
let _e779 = type_19(_e753.member, _e753.member_1, _e753.member_2, _e753.member_3, _e753.member_4, _e753.member_5, _e753.member_6, _e753.member_7, _e753.member_8, _e753.member_9, (_e629.member_10 + select(0f, _e629.member_21, (_e629.member_8 == 0f))), _e753.member_11, _e753.member_12, _e753.member_13, _e753.member_14, _e753.member_15, _e753.member_16, _e753.member_17, _e753.member_18, _e753.member_19, _e753.member_20, _e753.member_21);
phi_2012_ = type_19(_e779.member, _e779.member_1, _e779.member_2, _e779.member_3, _e779.member_4, _e779.member_5, 3f, _e779.member_7, _e779.member_8, _e779.member_9, _e779.member_10, _e779.member_11, _e779.member_12, _e779.member_13, _e779.member_14, _e779.member_15, _e779.member_16, _e779.member_17, _e779.member_18, _e779.member_19, _e779.member_20, _e779.member_21);
}
let _e825 = phi_2012_;
phi_2014_ = _e825;
} else {
phi_2014_ = type_19(_e629.member, _e629.member_1, _e629.member_2, _e629.member_3, _e629.member_4, _e629.member_5, 0f, _e629.member_7, _e629.member_8, _e629.member_9, _e629.member_10, _e629.member_11, _e629.member_12, _e629.member_13, _e629.member_14, _e629.member_15, _e629.member_16, _e629.member_17, _e629.member_18, _e629.member_19, _e629.member_20, _e629.member_21);
}
let _e827 = phi_2014_;
phi_2015_ = _e827;
}
let _e1252 = phi_2015_;
phi_1046_ = _e1252;
phi_1049_ = (_e631 + 1i);
} else {
phi_1046_ = type_19();
phi_1049_ = i32();
}
let _e1254 = phi_1046_;
let _e1256 = phi_1049_;
continue;
continuing {
phi_1045_ = _e1254;
phi_1048_ = _e1256;
break if !(_e635);
}
}
let _e1259 = local;
let _e1263 = local_1;
let _e1267 = local_2;
let _e1271 = local_3;
let _e1275 = local_4;
let _e1279 = local_5;
let _e1283 = local_6;
let _e1287 = local_7;
let _e1291 = local_8;
let _e1295 = local_9;
let _e1299 = local_10;
let _e1303 = local_11;
let _e1307 = local_12;
let _e1311 = local_13;
let _e1315 = local_14;
let _e1319 = local_15;
let _e1322 = local_16;
let _e1326 = local_17;
let _e1329 = local_18;
let _e1332 = local_19;
let _e1335 = local_20;
let _e1338 = local_21;
let _e1342 = local_22;
let _e1346 = local_23;
let _e1350 = local_24;
let _e1354 = local_25;
let _e1358 = local_26;
let _e1362 = local_27;
let _e1366 = local_28;
let _e1370 = local_29;
let _e1374 = local_30;
let _e1378 = local_31;
let _e1382 = local_32;
let _e1386 = local_33;
let _e1390 = local_34;
let _e1394 = local_35;
let _e1398 = local_36;
let _e1402 = local_37;
let _e1406 = local_38;
let _e1410 = local_39;
let _e1414 = local_40;
let _e1418 = local_41;
let _e1422 = local_42;
global_4.member[_e95] = _e1259.member.x;
global_4.member[_e107] = _e1263.member.y;
global_4.member[_e118] = _e1267.member.z;
global_4.member[_e129] = _e1271.member_1.x;
global_4.member[_e140] = _e1275.member_1.y;
global_4.member[_e151] = _e1279.member_1.z;
global_4.member[_e162] = _e1283.member_2.x;
global_4.member[_e173] = _e1287.member_2.y;
global_4.member[_e184] = _e1291.member_2.z;
global_4.member[_e195] = _e1295.member_3.x;
global_4.member[_e206] = _e1299.member_3.y;
global_4.member[_e217] = _e1303.member_3.z;
global_4.member[_e228] = _e1307.member_4.x;
global_4.member[_e239] = _e1311.member_4.y;
global_4.member[_e250] = _e1315.member_4.z;
global_4.member[_e261] = _e1319.member_5;
let _e1459 = local_43;
global_4.member[_e272] = _e1459;
global_4.member[_e283] = f32(_e1322.member_7);
global_4.member[_e294] = _e1326.member_8;
global_4.member[_e305] = _e1329.member_9;
global_4.member[_e316] = _e1332.member_10;
global_4.member[_e327] = _e1335.member_11;
global_4.member[_e338] = _e1338.member_12.x;
global_4.member[_e349] = _e1342.member_12.y;
global_4.member[_e360] = _e1346.member_12.z;
global_4.member[_e371] = _e1350.member_13.x;
global_4.member[_e382] = _e1354.member_13.y;
global_4.member[_e393] = _e1358.member_13.z;
global_4.member[_e404] = _e1362.member_14.x;
global_4.member[_e415] = _e1366.member_14.y;
global_4.member[_e426] = _e1370.member_14.z;
global_4.member[_e437] = _e1374.member_15.x;
global_4.member[_e448] = _e1378.member_15.y;
global_4.member[_e459] = _e1382.member_15.z;
global_4.member[_e470] = _e1386.member_16.x;
global_4.member[_e481] = _e1390.member_16.y;
global_4.member[_e492] = _e1394.member_16.z;
global_4.member[_e503] = _e1398.member_17.x;
global_4.member[_e514] = _e1402.member_17.y;
global_4.member[_e525] = _e1406.member_17.z;
global_4.member[_e536] = f32(_e1410.member_18);
global_4.member[_e547] = f32(_e1414.member_19);
global_4.member[_e558] = f32(_e1418.member_20);
global_4.member[_e569] = _e1422.member_21;
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
