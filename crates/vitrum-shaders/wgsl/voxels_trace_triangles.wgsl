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
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_13 {
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
member_10: f32,
member_11: u32,
member_12: u32,
member_13: u32,
}
struct type_14 {
member: u32,
member_1: u32,
}
struct type_15 {
member: type_14,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_16 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_17 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_14,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_14,
member_18: type_15,
member_19: type_5,
member_20: type_16,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_18 {
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
member_20: type_12,
member_21: type_13,
member_22: type_17,
}
struct type_19 {
member: type_18,
}
struct type_21 {
member: array<f32>,
}
struct type_25 {
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
member_14: i32,
member_15: i32,
member_16: i32,
member_17: f32,
}
struct type_26 {
member: i32,
member_1: i32,
member_2: f32,
member_3: f32,
member_4: f32,
}
struct type_29 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_19;
@group(0) @binding(1)
var<storage> global_2: type_21;
@group(0) @binding(2)
var<storage> global_3: type_21;
@group(0) @binding(3)
var<storage> global_4: type_21;
@group(0) @binding(4)
var<storage, read_write> global_5: type_21;
@group(0) @binding(5)
var<storage, read_write> global_6: type_29;
fn function_() {
var phi_787_: u32;
var phi_1051_: f32;
var phi_1097_: i32;
var phi_1099_: type_26;
var phi_1102_: type_25;
var phi_1104_: i32;
var phi_1106_: i32;
var phi_2220_: i32;
var phi_2223_: i32;
var phi_2221_: i32;
var phi_2224_: i32;
var phi_2252_: i32;
var phi_2255_: i32;
var phi_2253_: i32;
var phi_2256_: i32;
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var phi_3888_: type_25;
var phi_4394_: type_25;
var phi_4792_: i32;
var phi_4794_: i32;
var phi_4822_: type_25;
var phi_4823_: type_25;
var phi_4903_: type_25;
var phi_4904_: type_25;
var phi_4922_: type_25;
var local_7: i32;
var local_8: i32;
var phi_5370_: type_25;
var phi_5371_: type_25;
var phi_5349_: type_25;
var phi_5372_: type_25;
var local_9: i32;
var local_10: i32;
var phi_2606_: type_25;
var phi_5378_: type_26;
var phi_5379_: type_25;
var phi_5380_: i32;
var phi_5381_: type_26;
var phi_5382_: type_25;
var phi_5383_: i32;
var phi_5385_: type_26;
var phi_5386_: type_25;
var phi_5387_: i32;
var phi_5389_: bool;
var phi_5400_: type_26;
var phi_5401_: type_25;
var phi_5402_: i32;
var phi_5404_: bool;
var phi_5405_: bool;
var phi_5702_: type_25;
var phi_5703_: type_25;
var local_11: i32;
var local_12: i32;
var phi_5970_: type_25;
var phi_6258_: type_26;
var phi_6259_: type_25;
var phi_6265_: type_26;
var phi_6266_: type_25;
var phi_1413_: i32;
var phi_2027_: i32;
var phi_2191_: type_26;
var phi_2183_: bool;
var phi_2184_: bool;
var phi_2192_: type_26;
var phi_2193_: bool;
var phi_2200_: type_26;
var phi_2201_: type_25;
var phi_2202_: type_26;
var phi_2203_: type_25;
var phi_2205_: type_26;
var phi_2206_: type_25;
var phi_2207_: bool;
var phi_2211_: type_26;
var phi_2212_: type_25;
var phi_2213_: bool;
var phi_2217_: type_26;
var phi_2218_: type_25;
var phi_6268_: type_26;
var phi_6269_: type_25;
var phi_6270_: i32;
var phi_1100_: type_26;
var phi_1103_: type_25;
var phi_1105_: i32;
var phi_1107_: i32;
var local_13: i32;
var local_14: i32;
var phi_6276_: i32;
var local_15: type_26;
var local_16: type_26;
var local_17: type_26;
var local_18: type_26;
var local_19: type_25;
var local_20: type_25;
var local_21: type_25;
var local_22: type_25;
var local_23: type_25;
var local_24: type_25;
var local_25: type_25;
var local_26: type_25;
var local_27: type_25;
var local_28: type_25;
var local_29: type_25;
var local_30: type_25;
var local_31: type_25;
var local_32: type_25;
var local_33: type_25;
var local_34: type_25;
var local_35: type_25;
var local_36: type_25;
var local_37: type_25;
var local_38: type_25;
var local_39: type_25;
var local_40: type_25;
var local_41: type_25;
var local_42: type_25;
var local_43: type_25;
var local_44: type_25;
var local_45: f32;
let _e106 = global;
let _e110 = arrayLength((&global_3.member));
let _e112 = arrayLength((&global_4.member));
let _e119 = global_1.member.member;
if (_e106.x < _e119.member) {
if (_e106.y < _e119.member_1) {
let _e126 = (_e119.member * _e119.member_1);
let _e128 = ((_e106.y * _e119.member) + _e106.x);
let _e129 = bitcast<i32>(_e128);
let _e131 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e133 = select(_e131, _e129, (_e129 < _e131));
let _e139 = global_5.member[bitcast<u32>(select(0i, _e133, (_e133 > 0i)))];
let _e140 = (_e126 + _e128);
let _e141 = bitcast<i32>(_e140);
let _e143 = select(_e131, _e141, (_e141 < _e131));
let _e149 = global_5.member[bitcast<u32>(select(0i, _e143, (_e143 > 0i)))];
let _e151 = ((2u * _e126) + _e128);
let _e152 = bitcast<i32>(_e151);
let _e154 = select(_e131, _e152, (_e152 < _e131));
let _e160 = global_5.member[bitcast<u32>(select(0i, _e154, (_e154 > 0i)))];
let _e162 = ((3u * _e126) + _e128);
let _e163 = bitcast<i32>(_e162);
let _e165 = select(_e131, _e163, (_e163 < _e131));
let _e171 = global_5.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e173 = ((4u * _e126) + _e128);
let _e174 = bitcast<i32>(_e173);
let _e176 = select(_e131, _e174, (_e174 < _e131));
let _e182 = global_5.member[bitcast<u32>(select(0i, _e176, (_e176 > 0i)))];
let _e184 = ((5u * _e126) + _e128);
let _e185 = bitcast<i32>(_e184);
let _e187 = select(_e131, _e185, (_e185 < _e131));
let _e193 = global_5.member[bitcast<u32>(select(0i, _e187, (_e187 > 0i)))];
let _e195 = ((6u * _e126) + _e128);
let _e196 = bitcast<i32>(_e195);
let _e198 = select(_e131, _e196, (_e196 < _e131));
let _e204 = global_5.member[bitcast<u32>(select(0i, _e198, (_e198 > 0i)))];
let _e206 = ((7u * _e126) + _e128);
let _e207 = bitcast<i32>(_e206);
let _e209 = select(_e131, _e207, (_e207 < _e131));
let _e215 = global_5.member[bitcast<u32>(select(0i, _e209, (_e209 > 0i)))];
let _e217 = ((8u * _e126) + _e128);
let _e218 = bitcast<i32>(_e217);
let _e220 = select(_e131, _e218, (_e218 < _e131));
let _e226 = global_5.member[bitcast<u32>(select(0i, _e220, (_e220 > 0i)))];
let _e228 = ((9u * _e126) + _e128);
let _e229 = bitcast<i32>(_e228);
let _e231 = select(_e131, _e229, (_e229 < _e131));
let _e237 = global_5.member[bitcast<u32>(select(0i, _e231, (_e231 > 0i)))];
let _e239 = ((10u * _e126) + _e128);
let _e240 = bitcast<i32>(_e239);
let _e242 = select(_e131, _e240, (_e240 < _e131));
let _e248 = global_5.member[bitcast<u32>(select(0i, _e242, (_e242 > 0i)))];
let _e250 = ((11u * _e126) + _e128);
let _e251 = bitcast<i32>(_e250);
let _e253 = select(_e131, _e251, (_e251 < _e131));
let _e259 = global_5.member[bitcast<u32>(select(0i, _e253, (_e253 > 0i)))];
let _e261 = ((12u * _e126) + _e128);
let _e262 = bitcast<i32>(_e261);
let _e264 = select(_e131, _e262, (_e262 < _e131));
let _e270 = global_5.member[bitcast<u32>(select(0i, _e264, (_e264 > 0i)))];
let _e272 = ((13u * _e126) + _e128);
let _e273 = bitcast<i32>(_e272);
let _e275 = select(_e131, _e273, (_e273 < _e131));
let _e281 = global_5.member[bitcast<u32>(select(0i, _e275, (_e275 > 0i)))];
let _e283 = ((14u * _e126) + _e128);
let _e284 = bitcast<i32>(_e283);
let _e286 = select(_e131, _e284, (_e284 < _e131));
let _e292 = global_5.member[bitcast<u32>(select(0i, _e286, (_e286 > 0i)))];
let _e294 = ((15u * _e126) + _e128);
let _e295 = bitcast<i32>(_e294);
let _e297 = select(_e131, _e295, (_e295 < _e131));
let _e303 = global_5.member[bitcast<u32>(select(0i, _e297, (_e297 > 0i)))];
let _e305 = ((16u * _e126) + _e128);
let _e306 = bitcast<i32>(_e305);
let _e308 = select(_e131, _e306, (_e306 < _e131));
let _e314 = global_5.member[bitcast<u32>(select(0i, _e308, (_e308 > 0i)))];
let _e316 = ((17u * _e126) + _e128);
let _e317 = bitcast<i32>(_e316);
let _e319 = select(_e131, _e317, (_e317 < _e131));
let _e325 = global_5.member[bitcast<u32>(select(0i, _e319, (_e319 > 0i)))];
let _e327 = ((18u * _e126) + _e128);
let _e328 = bitcast<i32>(_e327);
let _e330 = select(_e131, _e328, (_e328 < _e131));
let _e336 = global_5.member[bitcast<u32>(select(0i, _e330, (_e330 > 0i)))];
let _e338 = ((19u * _e126) + _e128);
let _e339 = bitcast<i32>(_e338);
let _e341 = select(_e131, _e339, (_e339 < _e131));
let _e347 = global_5.member[bitcast<u32>(select(0i, _e341, (_e341 > 0i)))];
let _e349 = ((20u * _e126) + _e128);
let _e350 = bitcast<i32>(_e349);
let _e352 = select(_e131, _e350, (_e350 < _e131));
let _e358 = global_5.member[bitcast<u32>(select(0i, _e352, (_e352 > 0i)))];
let _e360 = ((21u * _e126) + _e128);
let _e361 = bitcast<i32>(_e360);
let _e363 = select(_e131, _e361, (_e361 < _e131));
let _e369 = global_5.member[bitcast<u32>(select(0i, _e363, (_e363 > 0i)))];
let _e371 = ((22u * _e126) + _e128);
let _e372 = bitcast<i32>(_e371);
let _e374 = select(_e131, _e372, (_e372 < _e131));
let _e380 = global_5.member[bitcast<u32>(select(0i, _e374, (_e374 > 0i)))];
let _e382 = ((23u * _e126) + _e128);
let _e383 = bitcast<i32>(_e382);
let _e385 = select(_e131, _e383, (_e383 < _e131));
let _e391 = global_5.member[bitcast<u32>(select(0i, _e385, (_e385 > 0i)))];
let _e393 = ((24u * _e126) + _e128);
let _e394 = bitcast<i32>(_e393);
let _e396 = select(_e131, _e394, (_e394 < _e131));
let _e402 = global_5.member[bitcast<u32>(select(0i, _e396, (_e396 > 0i)))];
let _e404 = ((25u * _e126) + _e128);
let _e405 = bitcast<i32>(_e404);
let _e407 = select(_e131, _e405, (_e405 < _e131));
let _e413 = global_5.member[bitcast<u32>(select(0i, _e407, (_e407 > 0i)))];
let _e415 = ((26u * _e126) + _e128);
let _e416 = bitcast<i32>(_e415);
let _e418 = select(_e131, _e416, (_e416 < _e131));
let _e424 = global_5.member[bitcast<u32>(select(0i, _e418, (_e418 > 0i)))];
let _e426 = ((27u * _e126) + _e128);
let _e427 = bitcast<i32>(_e426);
let _e429 = select(_e131, _e427, (_e427 < _e131));
let _e435 = global_5.member[bitcast<u32>(select(0i, _e429, (_e429 > 0i)))];
let _e437 = ((28u * _e126) + _e128);
let _e438 = bitcast<i32>(_e437);
let _e440 = select(_e131, _e438, (_e438 < _e131));
let _e446 = global_5.member[bitcast<u32>(select(0i, _e440, (_e440 > 0i)))];
let _e448 = ((29u * _e126) + _e128);
let _e449 = bitcast<i32>(_e448);
let _e451 = select(_e131, _e449, (_e449 < _e131));
let _e457 = global_5.member[bitcast<u32>(select(0i, _e451, (_e451 > 0i)))];
let _e459 = ((30u * _e126) + _e128);
let _e460 = bitcast<i32>(_e459);
let _e462 = select(_e131, _e460, (_e460 < _e131));
let _e468 = global_5.member[bitcast<u32>(select(0i, _e462, (_e462 > 0i)))];
let _e470 = ((31u * _e126) + _e128);
let _e471 = bitcast<i32>(_e470);
let _e473 = select(_e131, _e471, (_e471 < _e131));
let _e479 = global_5.member[bitcast<u32>(select(0i, _e473, (_e473 > 0i)))];
if (_e314 == 0f) {
phi_787_ = 3u;
} else {
phi_787_ = select(0u, 1u, (_e314 == 4f));
}
let _e484 = phi_787_;
if (_e484 > 0u) {
if (arrayLength((&global_6.member)) >= 3u) {
let _e493 = atomicLoad((&global_6.member[0u]));
if (_e493 == 0u) {
atomicStore((&global_6.member[0u]), ((_e119.member + 7u) / 8u));
atomicStore((&global_6.member[1u]), ((_e119.member_1 + 7u) / 8u));
atomicStore((&global_6.member[2u]), 1u);
}
}
}
if (_e484 > 1u) {
let _e512 = select(0i, select(select(i32(_e325), i32(-2147483648), (_e325 < -2147483600f)), 2147483647i, (_e325 > 2147483500f)), (_e325 == _e325));
let _e535 = select(0i, select(select(i32(_e468), i32(-2147483648), (_e468 < -2147483600f)), 2147483647i, (_e468 > 2147483500f)), (_e468 == _e468));
if (_e535 >= 0i) {
let _e538 = (_e535 * 19i);
let _e540 = (bitcast<i32>(_e110) - 1i);
let _e542 = select(_e540, _e538, (_e538 < _e540));
let _e548 = global_3.member[bitcast<u32>(select(0i, _e542, (_e542 > 0i)))];
let _e549 = (_e538 + 1i);
let _e551 = select(_e540, _e549, (_e549 < _e540));
let _e557 = global_3.member[bitcast<u32>(select(0i, _e551, (_e551 > 0i)))];
let _e558 = (_e538 + 2i);
let _e560 = select(_e540, _e558, (_e558 < _e540));
let _e566 = global_3.member[bitcast<u32>(select(0i, _e560, (_e560 > 0i)))];
let _e567 = (_e538 + 3i);
let _e569 = select(_e540, _e567, (_e567 < _e540));
let _e575 = global_3.member[bitcast<u32>(select(0i, _e569, (_e569 > 0i)))];
let _e576 = (_e538 + 4i);
let _e578 = select(_e540, _e576, (_e576 < _e540));
let _e584 = global_3.member[bitcast<u32>(select(0i, _e578, (_e578 > 0i)))];
let _e585 = (_e538 + 5i);
let _e587 = select(_e540, _e585, (_e585 < _e540));
let _e593 = global_3.member[bitcast<u32>(select(0i, _e587, (_e587 > 0i)))];
let _e594 = (_e575 - _e548);
let _e595 = (_e584 - _e557);
let _e596 = (_e593 - _e566);
let _e597 = (_e538 + 6i);
let _e599 = select(_e540, _e597, (_e597 < _e540));
let _e605 = global_3.member[bitcast<u32>(select(0i, _e599, (_e599 > 0i)))];
let _e606 = (_e538 + 7i);
let _e608 = select(_e540, _e606, (_e606 < _e540));
let _e614 = global_3.member[bitcast<u32>(select(0i, _e608, (_e608 > 0i)))];
let _e615 = (_e538 + 8i);
let _e617 = select(_e540, _e615, (_e615 < _e540));
let _e623 = global_3.member[bitcast<u32>(select(0i, _e617, (_e617 > 0i)))];
let _e624 = (_e605 - _e548);
let _e625 = (_e614 - _e557);
let _e626 = (_e623 - _e566);
let _e629 = ((_e595 * _e626) - (_e596 * _e625));
let _e632 = ((_e596 * _e624) - (_e594 * _e626));
let _e635 = ((_e594 * _e625) - (_e595 * _e624));
let _e640 = (((_e629 * _e629) + (_e632 * _e632)) + (_e635 * _e635));
let _e643 = sqrt(select(0f, _e640, (_e640 > 0f)));
let _e646 = (1f / select(1e-20f, _e643, (_e643 > 1e-20f)));
phi_1051_ = (((_e171 * (_e629 * _e646)) + (_e182 * (_e632 * _e646))) + (_e193 * (_e635 * _e646)));
} else {
phi_1051_ = 1f;
}
let _e656 = phi_1051_;
let _e673 = bitcast<f32>((bitcast<u32>(_e656) & 2147483647u));
let _e677 = bitcast<i32>(arrayLength((&global_2.member)));
if (_e512 == 16i) {
phi_1097_ = 0i;
} else {
phi_1097_ = -(_e512);
}
let _e682 = phi_1097_;
phi_1099_ = type_26(select(0i, select(select(i32(_e270), i32(-2147483648), (_e270 < -2147483600f)), 2147483647i, (_e270 > 2147483500f)), (_e270 == _e270)), select(0i, select(select(i32(_e281), i32(-2147483648), (_e281 < -2147483600f)), 2147483647i, (_e281 > 2147483500f)), (_e281 == _e281)), _e292, _e303, select(1e-3f, _e673, (_e673 > 1e-3f)));
phi_1102_ = type_25(vec3<f32>(_e139, _e149, _e160), vec3<f32>(_e171, _e182, _e193), vec3<f32>(_e204, _e215, _e226), vec3<f32>(_e237, _e248, _e259), vec3<f32>(_e270, _e281, _e292), _e303, _e314, _e512, _e336, _e347, _e358, _e369, vec3<f32>(_e380, _e391, _e402), vec3<f32>(_e413, _e424, _e435), select(0i, select(select(i32(_e446), i32(-2147483648), (_e446 < -2147483600f)), 2147483647i, (_e446 > 2147483500f)), (_e446 == _e446)), select(0i, select(select(i32(_e457), i32(-2147483648), (_e457 < -2147483600f)), 2147483647i, (_e457 > 2147483500f)), (_e457 == _e457)), _e535, _e479);
phi_1104_ = 0i;
phi_1106_ = _e682;
loop {
let _e684 = phi_1099_;
let _e686 = phi_1102_;
let _e688 = phi_1104_;
let _e690 = phi_1106_;
local_13 = _e690;
local_14 = _e690;
local_15 = _e684;
local_16 = _e684;
local_17 = _e684;
local_18 = _e684;
local_19 = _e686;
local_20 = _e686;
local_21 = _e686;
local_22 = _e686;
local_23 = _e686;
local_24 = _e686;
local_25 = _e686;
local_26 = _e686;
local_27 = _e686;
local_28 = _e686;
local_29 = _e686;
local_30 = _e686;
local_31 = _e686;
local_32 = _e686;
local_33 = _e686;
local_34 = _e686;
local_35 = _e686;
local_36 = _e686;
local_37 = _e686;
local_38 = _e686;
local_39 = _e686;
local_40 = _e686;
local_41 = _e686;
local_42 = _e686;
local_43 = _e686;
local_44 = _e686;
let _e694 = ((_e688 < 1024i) && (_e686.member_6 == 0f));
local_45 = _e686.member_6;
if _e694 {
if (_e686.member_15 < (_e677 / 8i)) {
let _e3465 = global_1.member.member_13;
let _e3467 = (_e686.member_16 >= 0i);
let _e3472 = (_e686.member_17 + select(0f, (_e3465 / _e684.member_4), _e3467));
let _e3480 = (_e686.member_15 * 8i);
let _e3488 = (1f / select(_e686.member_1.x, select(1e-12f, -1e-12f, (_e686.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e686.member_1.x) & 2147483647u)) < 1e-12f)));
let _e3496 = (1f / select(_e686.member_1.y, select(1e-12f, -1e-12f, (_e686.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e686.member_1.y) & 2147483647u)) < 1e-12f)));
let _e3504 = (1f / select(_e686.member_1.z, select(1e-12f, -1e-12f, (_e686.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e686.member_1.z) & 2147483647u)) < 1e-12f)));
let _e3506 = (_e677 - 1i);
let _e3508 = select(_e3506, _e3480, (_e3480 < _e3506));
let _e3514 = global_2.member[bitcast<u32>(select(0i, _e3508, (_e3508 > 0i)))];
let _e3515 = (_e3480 + 1i);
let _e3517 = select(_e3506, _e3515, (_e3515 < _e3506));
let _e3523 = global_2.member[bitcast<u32>(select(0i, _e3517, (_e3517 > 0i)))];
let _e3524 = (_e3480 + 2i);
let _e3526 = select(_e3506, _e3524, (_e3524 < _e3506));
let _e3532 = global_2.member[bitcast<u32>(select(0i, _e3526, (_e3526 > 0i)))];
let _e3533 = (_e3480 + 3i);
let _e3535 = select(_e3506, _e3533, (_e3533 < _e3506));
let _e3541 = global_2.member[bitcast<u32>(select(0i, _e3535, (_e3535 > 0i)))];
let _e3542 = (_e3480 + 4i);
let _e3544 = select(_e3506, _e3542, (_e3542 < _e3506));
let _e3550 = global_2.member[bitcast<u32>(select(0i, _e3544, (_e3544 > 0i)))];
let _e3551 = (_e3480 + 5i);
let _e3553 = select(_e3506, _e3551, (_e3551 < _e3506));
let _e3559 = global_2.member[bitcast<u32>(select(0i, _e3553, (_e3553 > 0i)))];
let _e3562 = ((_e3514 - _e686.member.x) * _e3488);
let _e3564 = ((_e3541 - _e686.member.x) * _e3488);
let _e3567 = ((_e3523 - _e686.member.y) * _e3496);
let _e3569 = ((_e3550 - _e686.member.y) * _e3496);
let _e3572 = ((_e3532 - _e686.member.z) * _e3504);
let _e3574 = ((_e3559 - _e686.member.z) * _e3504);
let _e3576 = select(_e3564, _e3562, (_e3562 < _e3564));
let _e3578 = select(_e3569, _e3567, (_e3567 < _e3569));
let _e3580 = select(_e3578, _e3576, (_e3576 > _e3578));
let _e3582 = select(_e3574, _e3572, (_e3572 < _e3574));
let _e3586 = select(_e3564, _e3562, (_e3562 > _e3564));
let _e3588 = select(_e3569, _e3567, (_e3567 > _e3569));
let _e3590 = select(_e3588, _e3586, (_e3586 < _e3588));
let _e3592 = select(_e3574, _e3572, (_e3572 > _e3574));
let _e3594 = select(_e3592, _e3590, (_e3590 < _e3592));
let _e3599 = ((select(_e3582, _e3580, (_e3580 > _e3582)) <= select(_e3472, _e3594, (_e3594 < _e3472))) && (_e3594 >= _e684.member_2));
let _e3600 = (_e3480 + 6i);
let _e3602 = select(_e3506, _e3600, (_e3600 < _e3506));
let _e3608 = global_2.member[bitcast<u32>(select(0i, _e3602, (_e3602 > 0i)))];
if _e3599 {
phi_1413_ = (_e686.member_15 + 1i);
} else {
let _e3616 = (_e3480 + 7i);
let _e3618 = select(_e3506, _e3616, (_e3616 < _e3506));
let _e3624 = global_2.member[bitcast<u32>(select(0i, _e3618, (_e3618 > 0i)))];
phi_1413_ = select(0i, select(select(i32(_e3624), i32(-2147483648), (_e3624 < -2147483600f)), 2147483647i, (_e3624 > 2147483500f)), (_e3624 == _e3624));
}
let _e3634 = phi_1413_;
let _e3652 = type_25(_e686.member, _e686.member_1, _e686.member_2, _e686.member_3, _e686.member_4, _e686.member_5, _e686.member_6, _e686.member_7, _e686.member_8, _e686.member_9, _e686.member_10, _e686.member_11, _e686.member_12, _e686.member_13, _e686.member_14, _e3634, _e686.member_16, _e686.member_17);
let _e3653 = select(-1i, select(0i, select(select(i32(_e3608), i32(-2147483648), (_e3608 < -2147483600f)), 2147483647i, (_e3608 > 2147483500f)), (_e3608 == _e3608)), _e3599);
if (_e3653 < 0i) {
phi_2211_ = type_26();
phi_2212_ = type_25();
phi_2213_ = true;
} else {
let _e3659 = bitcast<f32>((bitcast<u32>(_e686.member_1.x) & 2147483647u));
let _e3663 = bitcast<f32>((bitcast<u32>(_e686.member_1.y) & 2147483647u));
let _e3667 = bitcast<f32>((bitcast<u32>(_e686.member_1.z) & 2147483647u));
let _e3670 = ((_e3659 >= _e3663) && (_e3659 >= _e3667));
let _e3673 = (!(_e3670) && (_e3663 >= _e3667));
let _e3680 = (1f / select(select(_e686.member_1.z, _e686.member_1.y, _e3673), _e686.member_1.x, _e3670));
let _e3681 = (select(select(_e686.member_1.x, _e686.member_1.z, _e3673), _e686.member_1.y, _e3670) * _e3680);
let _e3682 = (select(select(_e686.member_1.y, _e686.member_1.x, _e3673), _e686.member_1.z, _e3670) * _e3680);
let _e3683 = (_e3653 * 19i);
let _e3685 = (bitcast<i32>(_e110) - 1i);
let _e3687 = select(_e3685, _e3683, (_e3683 < _e3685));
let _e3693 = global_3.member[bitcast<u32>(select(0i, _e3687, (_e3687 > 0i)))];
let _e3694 = (_e3683 + 1i);
let _e3696 = select(_e3685, _e3694, (_e3694 < _e3685));
let _e3702 = global_3.member[bitcast<u32>(select(0i, _e3696, (_e3696 > 0i)))];
let _e3703 = (_e3683 + 2i);
let _e3705 = select(_e3685, _e3703, (_e3703 < _e3685));
let _e3711 = global_3.member[bitcast<u32>(select(0i, _e3705, (_e3705 > 0i)))];
let _e3712 = (_e3693 - _e686.member.x);
let _e3713 = (_e3702 - _e686.member.y);
let _e3714 = (_e3711 - _e686.member.z);
let _e3720 = select(select(_e3714, _e3713, _e3673), _e3712, _e3670);
let _e3722 = (select(select(_e3712, _e3714, _e3673), _e3713, _e3670) - (_e3681 * _e3720));
let _e3724 = (select(select(_e3713, _e3712, _e3673), _e3714, _e3670) - (_e3682 * _e3720));
let _e3726 = (_e3683 + 3i);
let _e3728 = select(_e3685, _e3726, (_e3726 < _e3685));
let _e3734 = global_3.member[bitcast<u32>(select(0i, _e3728, (_e3728 > 0i)))];
let _e3735 = (_e3683 + 4i);
let _e3737 = select(_e3685, _e3735, (_e3735 < _e3685));
let _e3743 = global_3.member[bitcast<u32>(select(0i, _e3737, (_e3737 > 0i)))];
let _e3744 = (_e3683 + 5i);
let _e3746 = select(_e3685, _e3744, (_e3744 < _e3685));
let _e3752 = global_3.member[bitcast<u32>(select(0i, _e3746, (_e3746 > 0i)))];
let _e3753 = (_e3734 - _e686.member.x);
let _e3754 = (_e3743 - _e686.member.y);
let _e3755 = (_e3752 - _e686.member.z);
let _e3761 = select(select(_e3755, _e3754, _e3673), _e3753, _e3670);
let _e3763 = (select(select(_e3753, _e3755, _e3673), _e3754, _e3670) - (_e3681 * _e3761));
let _e3765 = (select(select(_e3754, _e3753, _e3673), _e3755, _e3670) - (_e3682 * _e3761));
let _e3767 = (_e3683 + 6i);
let _e3769 = select(_e3685, _e3767, (_e3767 < _e3685));
let _e3775 = global_3.member[bitcast<u32>(select(0i, _e3769, (_e3769 > 0i)))];
let _e3776 = (_e3683 + 7i);
let _e3778 = select(_e3685, _e3776, (_e3776 < _e3685));
let _e3784 = global_3.member[bitcast<u32>(select(0i, _e3778, (_e3778 > 0i)))];
let _e3785 = (_e3683 + 8i);
let _e3787 = select(_e3685, _e3785, (_e3785 < _e3685));
let _e3793 = global_3.member[bitcast<u32>(select(0i, _e3787, (_e3787 > 0i)))];
let _e3794 = (_e3775 - _e686.member.x);
let _e3795 = (_e3784 - _e686.member.y);
let _e3796 = (_e3793 - _e686.member.z);
let _e3802 = select(select(_e3796, _e3795, _e3673), _e3794, _e3670);
let _e3804 = (select(select(_e3794, _e3796, _e3673), _e3795, _e3670) - (_e3681 * _e3802));
let _e3806 = (select(select(_e3795, _e3794, _e3673), _e3796, _e3670) - (_e3682 * _e3802));
let _e3810 = ((_e3804 * _e3765) - (_e3806 * _e3763));
let _e3813 = ((_e3722 * _e3806) - (_e3724 * _e3804));
let _e3816 = ((_e3763 * _e3724) - (_e3765 * _e3722));
let _e3818 = ((_e3810 + _e3813) + _e3816);
let _e3832 = (!(((((_e3810 < 0f) || (_e3813 < 0f)) || (_e3816 < 0f)) && (((_e3810 > 0f) || (_e3813 > 0f)) || (_e3816 > 0f)))) && (_e3818 != 0f));
let _e3840 = select(1e30f, ((((_e3810 * (_e3720 * _e3680)) + (_e3813 * (_e3761 * _e3680))) + (_e3816 * (_e3802 * _e3680))) / select(1f, _e3818, _e3832)), _e3832);
if (_e3840 >= _e3472) {
phi_2205_ = type_26();
phi_2206_ = type_25();
phi_2207_ = true;
} else {
let _e3842 = (_e3734 - _e3693);
let _e3843 = (_e3743 - _e3702);
let _e3844 = (_e3752 - _e3711);
let _e3845 = (_e3775 - _e3693);
let _e3846 = (_e3784 - _e3702);
let _e3847 = (_e3793 - _e3711);
let _e3850 = ((_e3843 * _e3847) - (_e3844 * _e3846));
let _e3853 = ((_e3844 * _e3845) - (_e3842 * _e3847));
let _e3856 = ((_e3842 * _e3846) - (_e3843 * _e3845));
let _e3861 = (((_e3850 * _e3850) + (_e3853 * _e3853)) + (_e3856 * _e3856));
let _e3864 = sqrt(select(0f, _e3861, (_e3861 > 0f)));
let _e3867 = (1f / select(1e-20f, _e3864, (_e3864 > 1e-20f)));
let _e3875 = (((_e686.member_1.x * (_e3850 * _e3867)) + (_e686.member_1.y * (_e3853 * _e3867))) + (_e686.member_1.z * (_e3856 * _e3867)));
let _e3878 = bitcast<f32>((bitcast<u32>(_e3875) & 2147483647u));
let _e3880 = select(1e-3f, _e3878, (_e3878 > 1e-3f));
let _e3881 = (_e3683 + 18i);
let _e3883 = select(_e3685, _e3881, (_e3881 < _e3685));
let _e3889 = global_3.member[bitcast<u32>(select(0i, _e3883, (_e3883 > 0i)))];
let _e3896 = select(0i, select(select(i32(_e3889), i32(-2147483648), (_e3889 < -2147483600f)), 2147483647i, (_e3889 > 2147483500f)), (_e3889 == _e3889));
let _e3897 = (_e3896 * 4i);
let _e3899 = (bitcast<i32>(_e112) - 1i);
let _e3901 = select(_e3899, _e3897, (_e3897 < _e3899));
let _e3907 = global_4.member[bitcast<u32>(select(0i, _e3901, (_e3901 > 0i)))];
let _e3909 = select(_e3907, 1f, (_e3896 == 16i));
let _e3910 = (_e3909 <= 0f);
if _e3910 {
phi_2027_ = 0i;
} else {
phi_2027_ = (1i << bitcast<u32>((_e3896 & 31i)));
}
let _e3915 = phi_2027_;
let _e3916 = (_e3875 < 0f);
let _e3917 = select(_e3915, 0i, _e3916);
let _e3918 = select(0i, _e3915, _e3916);
let _e3927 = (_e3840 * _e3880);
let _e3940 = (((_e3840 > _e684.member_2) && (_e684.member_2 > 0f)) || (((_e3927 > (_e3465 * 2f)) || ((((_e3909 == 0f) || ((_e3918 & ~(_e690)) != 0i)) || ((_e3917 & _e690) != 0i)) && (_e3927 >= -((_e3465 * 0.5f))))) && (_e684.member_2 <= 0f)));
if _e3940 {
let _e3941 = (_e3840 < _e686.member_17);
if (_e3467 && ((bitcast<f32>((bitcast<u32>((_e3840 - _e686.member_17)) & 2147483647u)) * select(_e684.member_4, _e3880, (_e3880 > _e684.member_4))) <= _e3465)) {
let _e3974 = type_26((_e684.member | _e3918), _e684.member_1, _e684.member_2, _e684.member_3, _e684.member_4);
let _e3981 = type_26(_e3974.member, (_e684.member_1 | _e3917), _e3974.member_2, _e3974.member_3, _e3974.member_4);
let _e3991 = ((_e686.member_16 * 19i) + 18i);
let _e3993 = select(_e3685, _e3991, (_e3991 < _e3685));
let _e3999 = global_3.member[bitcast<u32>(select(0i, _e3993, (_e3993 > 0i)))];
let _e4006 = select(0i, select(select(i32(_e3999), i32(-2147483648), (_e3999 < -2147483600f)), 2147483647i, (_e3999 > 2147483500f)), (_e3999 == _e3999));
let _e4007 = (_e4006 * 4i);
let _e4009 = select(_e3899, _e4007, (_e4007 < _e3899));
let _e4015 = global_4.member[bitcast<u32>(select(0i, _e4009, (_e4009 > 0i)))];
if (_e3910 != (select(_e4015, 1f, (_e4006 == 16i)) <= 0f)) {
phi_2184_ = _e3910;
} else {
if (!(_e3910) && (_e3896 != _e4006)) {
phi_2183_ = (_e3896 < _e4006);
} else {
phi_2183_ = _e3941;
}
let _e4025 = phi_2183_;
phi_2184_ = _e4025;
}
let _e4027 = phi_2184_;
phi_2192_ = type_26(_e3981.member, _e3981.member_1, _e3981.member_2, select(_e3840, _e684.member_3, (_e684.member_3 > _e3840)), _e3981.member_4);
phi_2193_ = _e4027;
} else {
if _e3941 {
let _e3955 = type_26(_e3918, _e684.member_1, _e684.member_2, _e684.member_3, _e684.member_4);
let _e3960 = type_26(_e3955.member, _e3917, _e3955.member_2, _e3955.member_3, _e3955.member_4);
phi_2191_ = type_26(_e3960.member, _e3960.member_1, _e3960.member_2, _e3840, _e3960.member_4);
} else {
phi_2191_ = _e684;
}
let _e3967 = phi_2191_;
phi_2192_ = _e3967;
phi_2193_ = _e3941;
}
let _e4029 = phi_2192_;
let _e4031 = phi_2193_;
if _e4031 {
let _e4049 = type_25(_e3652.member, _e3652.member_1, _e3652.member_2, _e3652.member_3, _e3652.member_4, _e3652.member_5, _e3652.member_6, _e3652.member_7, _e3652.member_8, _e3652.member_9, _e3652.member_10, _e3652.member_11, _e3652.member_12, _e3652.member_13, _e3652.member_14, _e3652.member_15, _e3653, _e3652.member_17);
phi_2200_ = type_26(_e4029.member, _e4029.member_1, _e4029.member_2, _e4029.member_3, _e3880);
phi_2201_ = type_25(_e4049.member, _e4049.member_1, _e4049.member_2, _e4049.member_3, _e4049.member_4, _e4049.member_5, _e4049.member_6, _e4049.member_7, _e4049.member_8, _e4049.member_9, _e4049.member_10, _e4049.member_11, _e4049.member_12, _e4049.member_13, _e4049.member_14, _e4049.member_15, _e4049.member_16, _e3840);
} else {
phi_2200_ = _e4029;
phi_2201_ = _e3652;
}
let _e4074 = phi_2200_;
let _e4076 = phi_2201_;
phi_2202_ = _e4074;
phi_2203_ = _e4076;
} else {
phi_2202_ = type_26();
phi_2203_ = type_25();
}
let _e4078 = phi_2202_;
let _e4080 = phi_2203_;
phi_2205_ = _e4078;
phi_2206_ = _e4080;
phi_2207_ = select(true, false, _e3940);
}
let _e4083 = phi_2205_;
let _e4085 = phi_2206_;
let _e4087 = phi_2207_;
phi_2211_ = _e4083;
phi_2212_ = _e4085;
phi_2213_ = _e4087;
}
let _e4089 = phi_2211_;
let _e4091 = phi_2212_;
let _e4093 = phi_2213_;
if _e4093 {
phi_2217_ = _e684;
phi_2218_ = _e3652;
} else {
phi_2217_ = _e4089;
phi_2218_ = _e4091;
}
let _e4095 = phi_2217_;
let _e4097 = phi_2218_;
phi_6268_ = _e4095;
phi_6269_ = _e4097;
phi_6270_ = _e690;
} else {
phi_2220_ = 15i;
phi_2223_ = 16i;
loop {
let _e699 = phi_2220_;
let _e701 = phi_2223_;
local = _e701;
local_1 = _e701;
local_3 = _e701;
local_6 = _e701;
local_7 = _e701;
local_9 = _e701;
local_10 = _e701;
local_11 = _e701;
local_12 = _e701;
let _e702 = (_e699 >= 0i);
if _e702 {
phi_2221_ = (_e699 - 1i);
phi_2224_ = select(_e701, _e699, (((_e690 >> bitcast<u32>((_e699 & 31i))) & 1i) == 1i));
} else {
phi_2221_ = i32();
phi_2224_ = i32();
}
let _e711 = phi_2221_;
let _e713 = phi_2224_;
continue;
continuing {
phi_2220_ = _e711;
phi_2223_ = _e713;
break if !(_e702);
}
}
let _e716 = (_e686.member_16 >= 0i);
let _e725 = ((_e690 | (_e684.member & ~(_e684.member_1))) & ~((_e684.member_1 & ~(_e684.member))));
phi_2252_ = 15i;
phi_2255_ = 16i;
loop {
let _e727 = phi_2252_;
let _e729 = phi_2255_;
local_2 = _e729;
local_4 = _e729;
local_5 = _e729;
local_8 = _e729;
let _e730 = (_e727 >= 0i);
if _e730 {
phi_2253_ = (_e727 - 1i);
phi_2256_ = select(_e729, _e727, (((_e725 >> bitcast<u32>((_e727 & 31i))) & 1i) == 1i));
} else {
phi_2253_ = i32();
phi_2256_ = i32();
}
let _e739 = phi_2253_;
let _e741 = phi_2256_;
continue;
continuing {
phi_2252_ = _e739;
phi_2255_ = _e741;
break if !(_e730);
}
}
let _e744 = (_e686.member_16 == -1i);
let _e746 = local;
let _e747 = (_e746 == 16i);
let _e749 = (!(_e716) && (_e744 || _e747));
if _e716 {
let _e751 = (_e686.member_16 * 19i);
let _e752 = (_e751 + 18i);
let _e754 = (bitcast<i32>(_e110) - 1i);
let _e756 = select(_e754, _e752, (_e752 < _e754));
let _e762 = global_3.member[bitcast<u32>(select(0i, _e756, (_e756 > 0i)))];
let _e769 = select(0i, select(select(i32(_e762), i32(-2147483648), (_e762 < -2147483600f)), 2147483647i, (_e762 > 2147483500f)), (_e762 == _e762));
let _e770 = (_e769 * 4i);
let _e772 = (bitcast<i32>(_e112) - 1i);
let _e774 = select(_e772, _e770, (_e770 < _e772));
let _e780 = global_4.member[bitcast<u32>(select(0i, _e774, (_e774 > 0i)))];
let _e783 = (select(_e780, 1f, (_e769 == 16i)) <= 0f);
if _e749 {
phi_5385_ = type_26();
phi_5386_ = type_25();
phi_5387_ = i32();
phi_5389_ = false;
} else {
if _e783 {
phi_5381_ = type_26();
phi_5382_ = type_25();
phi_5383_ = i32();
} else {
let _e785 = local_1;
let _e787 = local_2;
if (_e785 == _e787) {
let _e2552 = (_e684.member_3 - _e684.member_2);
let _e2554 = select(0f, _e2552, (_e2552 > 0f));
let _e2556 = local_9;
if (_e2556 != 16i) {
let _e2577 = type_25(_e686.member, _e686.member_1, _e686.member_2, _e686.member_3, _e686.member_4, _e686.member_5, _e686.member_6, _e686.member_7, _e686.member_8, (_e686.member_9 + _e2554), _e686.member_10, _e686.member_11, _e686.member_12, _e686.member_13, _e686.member_14, _e686.member_15, _e686.member_16, _e686.member_17);
let _e2579 = local_10;
let _e2580 = (_e2579 * 4i);
let _e2581 = (_e2580 + 1i);
let _e2583 = select(_e772, _e2581, (_e2581 < _e772));
let _e2589 = global_4.member[bitcast<u32>(select(0i, _e2583, (_e2583 > 0i)))];
let _e2591 = -((_e2589 * _e2554));
let _e2593 = select(-87f, _e2591, (_e2591 > -87f));
let _e2595 = select(88f, _e2593, (_e2593 < 88f));
let _e2597 = ((_e2595 * 1.442695f) + 0.5f);
let _e2599 = select(-127f, _e2597, (_e2597 > -127f));
let _e2601 = select(128f, _e2599, (_e2599 < 128f));
let _e2608 = select(0i, select(select(i32(_e2601), i32(-2147483648), (_e2601 < -2147483600f)), 2147483647i, (_e2601 > 2147483500f)), (_e2601 == _e2601));
let _e2612 = (_e2608 - select(0i, 1i, (_e2601 < f32(_e2608))));
let _e2613 = f32(_e2612);
let _e2617 = ((_e2595 - (_e2613 * 0.6933594f)) - (_e2613 * -2.1219444e-4f));
let _e2638 = (_e2580 + 2i);
let _e2640 = select(_e772, _e2638, (_e2638 < _e772));
let _e2646 = global_4.member[bitcast<u32>(select(0i, _e2640, (_e2640 > 0i)))];
let _e2648 = -((_e2646 * _e2554));
let _e2650 = select(-87f, _e2648, (_e2648 > -87f));
let _e2652 = select(88f, _e2650, (_e2650 < 88f));
let _e2654 = ((_e2652 * 1.442695f) + 0.5f);
let _e2656 = select(-127f, _e2654, (_e2654 > -127f));
let _e2658 = select(128f, _e2656, (_e2656 < 128f));
let _e2665 = select(0i, select(select(i32(_e2658), i32(-2147483648), (_e2658 < -2147483600f)), 2147483647i, (_e2658 > 2147483500f)), (_e2658 == _e2658));
let _e2669 = (_e2665 - select(0i, 1i, (_e2658 < f32(_e2665))));
let _e2670 = f32(_e2669);
let _e2674 = ((_e2652 - (_e2670 * 0.6933594f)) - (_e2670 * -2.1219444e-4f));
let _e2695 = (_e2580 + 3i);
let _e2697 = select(_e772, _e2695, (_e2695 < _e772));
let _e2703 = global_4.member[bitcast<u32>(select(0i, _e2697, (_e2697 > 0i)))];
let _e2705 = -((_e2703 * _e2554));
let _e2707 = select(-87f, _e2705, (_e2705 > -87f));
let _e2709 = select(88f, _e2707, (_e2707 < 88f));
let _e2711 = ((_e2709 * 1.442695f) + 0.5f);
let _e2713 = select(-127f, _e2711, (_e2711 > -127f));
let _e2715 = select(128f, _e2713, (_e2713 < 128f));
let _e2722 = select(0i, select(select(i32(_e2715), i32(-2147483648), (_e2715 < -2147483600f)), 2147483647i, (_e2715 > 2147483500f)), (_e2715 == _e2715));
let _e2726 = (_e2722 - select(0i, 1i, (_e2715 < f32(_e2722))));
let _e2727 = f32(_e2726);
let _e2731 = ((_e2709 - (_e2727 * 0.6933594f)) - (_e2727 * -2.1219444e-4f));
phi_2606_ = type_25(_e2577.member, _e2577.member_1, vec3<f32>((_e686.member_2.x * ((1f + (_e2617 * (1f + (_e2617 * (0.5f + (_e2617 * (0.16666667f + (_e2617 * (0.041666668f + (_e2617 * (0.008333334f + (_e2617 * (0.001388889f + (_e2617 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2612 + 127i)) << bitcast<u32>(23i))))), (_e686.member_2.y * ((1f + (_e2674 * (1f + (_e2674 * (0.5f + (_e2674 * (0.16666667f + (_e2674 * (0.041666668f + (_e2674 * (0.008333334f + (_e2674 * (0.001388889f + (_e2674 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2669 + 127i)) << bitcast<u32>(23i))))), (_e686.member_2.z * ((1f + (_e2731 * (1f + (_e2731 * (0.5f + (_e2731 * (0.16666667f + (_e2731 * (0.041666668f + (_e2731 * (0.008333334f + (_e2731 * (0.001388889f + (_e2731 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2726 + 127i)) << bitcast<u32>(23i)))))), _e2577.member_3, _e2577.member_4, _e2577.member_5, _e2577.member_6, _e2577.member_7, _e2577.member_8, _e2577.member_9, _e2577.member_10, _e2577.member_11, _e2577.member_12, _e2577.member_13, _e2577.member_14, _e2577.member_15, _e2577.member_16, _e2577.member_17);
} else {
phi_2606_ = _e686;
}
let _e2781 = phi_2606_;
let _e2788 = type_26(0i, _e684.member_1, _e684.member_2, _e684.member_3, _e684.member_4);
let _e2793 = type_26(_e2788.member, 0i, _e2788.member_2, _e2788.member_3, _e2788.member_4);
let _e2805 = global_1.member.member_18.member.member;
let _e2819 = ((((_e2805.member.member * _e2781.member.x) + (_e2805.member.member_1 * _e2781.member.y)) + (_e2805.member.member_2 * _e2781.member.z)) + _e2805.member_1);
let _e2828 = -((((_e2805.member.member * _e2781.member_1.x) + (_e2805.member.member_1 * _e2781.member_1.y)) + (_e2805.member.member_2 * _e2781.member_1.z)));
let _e2830 = (_e2828 > 1e-9f);
let _e2834 = ((_e2819 / select(1e-9f, _e2828, _e2830)) - 0.015625f);
let _e2837 = select(1e30f, select(0f, _e2834, (_e2834 > 0f)), ((_e2819 > 0f) && _e2830));
let _e2842 = global_1.member.member_18.member_1.member;
let _e2853 = ((((_e2842.member.member * _e2781.member.x) + (_e2842.member.member_1 * _e2781.member.y)) + (_e2842.member.member_2 * _e2781.member.z)) + _e2842.member_1);
let _e2859 = -((((_e2842.member.member * _e2781.member_1.x) + (_e2842.member.member_1 * _e2781.member_1.y)) + (_e2842.member.member_2 * _e2781.member_1.z)));
let _e2861 = (_e2859 > 1e-9f);
let _e2865 = ((_e2853 / select(1e-9f, _e2859, _e2861)) - 0.015625f);
let _e2868 = select(1e30f, select(0f, _e2865, (_e2865 > 0f)), ((_e2853 > 0f) && _e2861));
let _e2872 = (_e2868 < _e2837);
let _e2893 = type_25(_e2781.member, _e2781.member_1, _e2781.member_2, _e2781.member_3, _e2781.member_4, _e2781.member_5, _e2781.member_6, _e2781.member_7, _e2781.member_8, _e2781.member_9, _e2781.member_10, _e2781.member_11, _e2781.member_12, _e2781.member_13, _e2781.member_14, 0i, _e2781.member_16, _e2781.member_17);
let _e2911 = type_25(_e2893.member, _e2893.member_1, _e2893.member_2, _e2893.member_3, _e2893.member_4, _e2893.member_5, _e2893.member_6, _e2893.member_7, _e2893.member_8, _e2893.member_9, _e2893.member_10, _e2893.member_11, _e2893.member_12, _e2893.member_13, _e2893.member_14, _e2893.member_15, select(select(-2i, -3i, _e2872), -1i, ((_e2837 >= 1e30f) && (_e2868 >= 1e30f))), _e2893.member_17);
phi_5378_ = type_26(_e2793.member, _e2793.member_1, select(1.1754944e-38f, _e684.member_3, (_e684.member_3 > 1.1754944e-38f)), _e2793.member_3, _e2793.member_4);
phi_5379_ = type_25(_e2911.member, _e2911.member_1, _e2911.member_2, _e2911.member_3, _e2911.member_4, _e2911.member_5, _e2911.member_6, _e2911.member_7, _e2911.member_8, _e2911.member_9, _e2911.member_10, _e2911.member_11, _e2911.member_12, _e2911.member_13, _e2911.member_14, _e2911.member_15, _e2911.member_16, select(_e2837, _e2868, _e2872));
phi_5380_ = _e725;
} else {
let _e790 = select(_e754, _e751, (_e751 < _e754));
let _e796 = global_3.member[bitcast<u32>(select(0i, _e790, (_e790 > 0i)))];
let _e797 = (_e751 + 1i);
let _e799 = select(_e754, _e797, (_e797 < _e754));
let _e805 = global_3.member[bitcast<u32>(select(0i, _e799, (_e799 > 0i)))];
let _e806 = (_e751 + 2i);
let _e808 = select(_e754, _e806, (_e806 < _e754));
let _e814 = global_3.member[bitcast<u32>(select(0i, _e808, (_e808 > 0i)))];
let _e815 = (_e751 + 3i);
let _e817 = select(_e754, _e815, (_e815 < _e754));
let _e823 = global_3.member[bitcast<u32>(select(0i, _e817, (_e817 > 0i)))];
let _e824 = (_e751 + 4i);
let _e826 = select(_e754, _e824, (_e824 < _e754));
let _e832 = global_3.member[bitcast<u32>(select(0i, _e826, (_e826 > 0i)))];
let _e833 = (_e751 + 5i);
let _e835 = select(_e754, _e833, (_e833 < _e754));
let _e841 = global_3.member[bitcast<u32>(select(0i, _e835, (_e835 > 0i)))];
let _e842 = (_e823 - _e796);
let _e843 = (_e832 - _e805);
let _e844 = (_e841 - _e814);
let _e845 = (_e751 + 6i);
let _e847 = select(_e754, _e845, (_e845 < _e754));
let _e853 = global_3.member[bitcast<u32>(select(0i, _e847, (_e847 > 0i)))];
let _e854 = (_e751 + 7i);
let _e856 = select(_e754, _e854, (_e854 < _e754));
let _e862 = global_3.member[bitcast<u32>(select(0i, _e856, (_e856 > 0i)))];
let _e863 = (_e751 + 8i);
let _e865 = select(_e754, _e863, (_e863 < _e754));
let _e871 = global_3.member[bitcast<u32>(select(0i, _e865, (_e865 > 0i)))];
let _e872 = (_e853 - _e796);
let _e873 = (_e862 - _e805);
let _e874 = (_e871 - _e814);
let _e877 = ((_e843 * _e874) - (_e844 * _e873));
let _e880 = ((_e844 * _e872) - (_e842 * _e874));
let _e883 = ((_e842 * _e873) - (_e843 * _e872));
let _e888 = (((_e877 * _e877) + (_e880 * _e880)) + (_e883 * _e883));
let _e891 = sqrt(select(0f, _e888, (_e888 > 0f)));
let _e894 = (1f / select(1e-20f, _e891, (_e891 > 1e-20f)));
let _e895 = (_e877 * _e894);
let _e896 = (_e880 * _e894);
let _e897 = (_e883 * _e894);
let _e903 = bitcast<f32>((bitcast<u32>(_e686.member_1.x) & 2147483647u));
let _e907 = bitcast<f32>((bitcast<u32>(_e686.member_1.y) & 2147483647u));
let _e911 = bitcast<f32>((bitcast<u32>(_e686.member_1.z) & 2147483647u));
let _e914 = ((_e903 >= _e907) && (_e903 >= _e911));
let _e917 = (!(_e914) && (_e907 >= _e911));
let _e924 = (1f / select(select(_e686.member_1.z, _e686.member_1.y, _e917), _e686.member_1.x, _e914));
let _e925 = (select(select(_e686.member_1.x, _e686.member_1.z, _e917), _e686.member_1.y, _e914) * _e924);
let _e926 = (select(select(_e686.member_1.y, _e686.member_1.x, _e917), _e686.member_1.z, _e914) * _e924);
let _e928 = (_e796 - _e686.member.x);
let _e930 = (_e805 - _e686.member.y);
let _e932 = (_e814 - _e686.member.z);
let _e938 = select(select(_e932, _e930, _e917), _e928, _e914);
let _e940 = (select(select(_e928, _e932, _e917), _e930, _e914) - (_e925 * _e938));
let _e942 = (select(select(_e930, _e928, _e917), _e932, _e914) - (_e926 * _e938));
let _e943 = (_e823 - _e686.member.x);
let _e944 = (_e832 - _e686.member.y);
let _e945 = (_e841 - _e686.member.z);
let _e951 = select(select(_e945, _e944, _e917), _e943, _e914);
let _e953 = (select(select(_e943, _e945, _e917), _e944, _e914) - (_e925 * _e951));
let _e955 = (select(select(_e944, _e943, _e917), _e945, _e914) - (_e926 * _e951));
let _e956 = (_e853 - _e686.member.x);
let _e957 = (_e862 - _e686.member.y);
let _e958 = (_e871 - _e686.member.z);
let _e964 = select(select(_e958, _e957, _e917), _e956, _e914);
let _e966 = (select(select(_e956, _e958, _e917), _e957, _e914) - (_e925 * _e964));
let _e968 = (select(select(_e957, _e956, _e917), _e958, _e914) - (_e926 * _e964));
let _e971 = ((_e966 * _e955) - (_e968 * _e953));
let _e974 = ((_e940 * _e968) - (_e942 * _e966));
let _e977 = ((_e953 * _e942) - (_e955 * _e940));
let _e979 = ((_e971 + _e974) + _e977);
let _e982 = (1f / select(_e979, 1f, (_e979 == 0f)));
let _e983 = (_e971 * _e982);
let _e984 = (_e974 * _e982);
let _e985 = (_e977 * _e982);
let _e986 = (_e751 + 9i);
let _e988 = select(_e754, _e986, (_e986 < _e754));
let _e994 = global_3.member[bitcast<u32>(select(0i, _e988, (_e988 > 0i)))];
let _e995 = (_e751 + 10i);
let _e997 = select(_e754, _e995, (_e995 < _e754));
let _e1003 = global_3.member[bitcast<u32>(select(0i, _e997, (_e997 > 0i)))];
let _e1004 = (_e751 + 11i);
let _e1006 = select(_e754, _e1004, (_e1004 < _e754));
let _e1012 = global_3.member[bitcast<u32>(select(0i, _e1006, (_e1006 > 0i)))];
let _e1016 = (_e751 + 12i);
let _e1018 = select(_e754, _e1016, (_e1016 < _e754));
let _e1024 = global_3.member[bitcast<u32>(select(0i, _e1018, (_e1018 > 0i)))];
let _e1025 = (_e751 + 13i);
let _e1027 = select(_e754, _e1025, (_e1025 < _e754));
let _e1033 = global_3.member[bitcast<u32>(select(0i, _e1027, (_e1027 > 0i)))];
let _e1034 = (_e751 + 14i);
let _e1036 = select(_e754, _e1034, (_e1034 < _e754));
let _e1042 = global_3.member[bitcast<u32>(select(0i, _e1036, (_e1036 > 0i)))];
let _e1049 = (_e751 + 15i);
let _e1051 = select(_e754, _e1049, (_e1049 < _e754));
let _e1057 = global_3.member[bitcast<u32>(select(0i, _e1051, (_e1051 > 0i)))];
let _e1058 = (_e751 + 16i);
let _e1060 = select(_e754, _e1058, (_e1058 < _e754));
let _e1066 = global_3.member[bitcast<u32>(select(0i, _e1060, (_e1060 > 0i)))];
let _e1067 = (_e751 + 17i);
let _e1069 = select(_e754, _e1067, (_e1067 < _e754));
let _e1075 = global_3.member[bitcast<u32>(select(0i, _e1069, (_e1069 > 0i)))];
let _e1079 = (((_e994 * _e983) + (_e1024 * _e984)) + (_e1057 * _e985));
let _e1080 = (((_e1003 * _e983) + (_e1033 * _e984)) + (_e1066 * _e985));
let _e1081 = (((_e1012 * _e983) + (_e1042 * _e984)) + (_e1075 * _e985));
let _e1086 = (((_e1079 * _e1079) + (_e1080 * _e1080)) + (_e1081 * _e1081));
let _e1089 = sqrt(select(0f, _e1086, (_e1086 > 0f)));
let _e1092 = (1f / select(1e-20f, _e1089, (_e1089 > 1e-20f)));
let _e1093 = (_e1079 * _e1092);
let _e1094 = (_e1080 * _e1092);
let _e1095 = (_e1081 * _e1092);
let _e1097 = local_3;
let _e1098 = (_e1097 * 4i);
let _e1100 = select(_e772, _e1098, (_e1098 < _e772));
let _e1106 = global_4.member[bitcast<u32>(select(0i, _e1100, (_e1100 > 0i)))];
let _e1107 = select(_e1106, 1f, _e747);
let _e1109 = local_4;
let _e1110 = (_e1109 * 4i);
let _e1112 = select(_e772, _e1110, (_e1110 < _e772));
let _e1118 = global_4.member[bitcast<u32>(select(0i, _e1112, (_e1112 > 0i)))];
let _e1120 = local_5;
let _e1122 = select(_e1118, 1f, (_e1120 == 16i));
let _e1129 = select(1f, -1f, ((((_e686.member_1.x * _e1093) + (_e686.member_1.y * _e1094)) + (_e686.member_1.z * _e1095)) > 0f));
let _e1130 = (_e1093 * _e1129);
let _e1131 = (_e1094 * _e1129);
let _e1132 = (_e1095 * _e1129);
let _e1138 = -((((_e686.member_1.x * _e1130) + (_e686.member_1.y * _e1131)) + (_e686.member_1.z * _e1132)));
let _e1140 = select(0f, _e1138, (_e1138 > 0f));
let _e1141 = (_e1107 / _e1122);
let _e1142 = (_e1141 * _e1141);
let _e1146 = (1f - (_e1142 * (1f - (_e1140 * _e1140))));
let _e1147 = (_e1146 <= 0f);
let _e1155 = ((_e1141 * _e1140) - sqrt(select(0f, _e1146, (_e1146 > 0f))));
let _e1162 = (2f * _e1140);
let _e1169 = select(((_e686.member_1.x * _e1141) + (_e1130 * _e1155)), (_e686.member_1.x + (_e1130 * _e1162)), _e1147);
let _e1170 = select(((_e686.member_1.y * _e1141) + (_e1131 * _e1155)), (_e686.member_1.y + (_e1131 * _e1162)), _e1147);
let _e1171 = select(((_e686.member_1.z * _e1141) + (_e1132 * _e1155)), (_e686.member_1.z + (_e1132 * _e1162)), _e1147);
let _e1176 = (((_e1169 * _e1169) + (_e1170 * _e1170)) + (_e1171 * _e1171));
let _e1179 = sqrt(select(0f, _e1176, (_e1176 > 0f)));
let _e1182 = (1f / select(1e-20f, _e1179, (_e1179 > 1e-20f)));
let _e1190 = (((_e686.member_1.x * _e895) + (_e686.member_1.y * _e896)) + (_e686.member_1.z * _e897));
let _e1207 = ((((((_e1093 * _e686.member_1.x) + (_e1094 * _e686.member_1.y)) + (_e1095 * _e686.member_1.z)) * _e1190) > 0f) && (((((((_e1169 * _e1182) * _e895) + ((_e1170 * _e1182) * _e896)) + ((_e1171 * _e1182) * _e897)) * select(1f, -1f, _e1147)) * _e1190) > 0f));
let _e1208 = select(_e895, _e1093, _e1207);
let _e1209 = select(_e896, _e1094, _e1207);
let _e1210 = select(_e897, _e1095, _e1207);
let _e1214 = (_e686.member_17 - _e684.member_2);
let _e1216 = select(0f, _e1214, (_e1214 > 0f));
let _e1218 = local_6;
if (_e1218 != 16i) {
let _e1239 = type_25(_e686.member, _e686.member_1, _e686.member_2, _e686.member_3, _e686.member_4, _e686.member_5, _e686.member_6, _e686.member_7, _e686.member_8, (_e686.member_9 + _e1216), _e686.member_10, _e686.member_11, _e686.member_12, _e686.member_13, _e686.member_14, _e686.member_15, _e686.member_16, _e686.member_17);
let _e1240 = (_e1098 + 1i);
let _e1242 = select(_e772, _e1240, (_e1240 < _e772));
let _e1248 = global_4.member[bitcast<u32>(select(0i, _e1242, (_e1242 > 0i)))];
let _e1250 = -((_e1248 * _e1216));
let _e1252 = select(-87f, _e1250, (_e1250 > -87f));
let _e1254 = select(88f, _e1252, (_e1252 < 88f));
let _e1256 = ((_e1254 * 1.442695f) + 0.5f);
let _e1258 = select(-127f, _e1256, (_e1256 > -127f));
let _e1260 = select(128f, _e1258, (_e1258 < 128f));
let _e1267 = select(0i, select(select(i32(_e1260), i32(-2147483648), (_e1260 < -2147483600f)), 2147483647i, (_e1260 > 2147483500f)), (_e1260 == _e1260));
let _e1271 = (_e1267 - select(0i, 1i, (_e1260 < f32(_e1267))));
let _e1272 = f32(_e1271);
let _e1276 = ((_e1254 - (_e1272 * 0.6933594f)) - (_e1272 * -2.1219444e-4f));
let _e1297 = (_e1098 + 2i);
let _e1299 = select(_e772, _e1297, (_e1297 < _e772));
let _e1305 = global_4.member[bitcast<u32>(select(0i, _e1299, (_e1299 > 0i)))];
let _e1307 = -((_e1305 * _e1216));
let _e1309 = select(-87f, _e1307, (_e1307 > -87f));
let _e1311 = select(88f, _e1309, (_e1309 < 88f));
let _e1313 = ((_e1311 * 1.442695f) + 0.5f);
let _e1315 = select(-127f, _e1313, (_e1313 > -127f));
let _e1317 = select(128f, _e1315, (_e1315 < 128f));
let _e1324 = select(0i, select(select(i32(_e1317), i32(-2147483648), (_e1317 < -2147483600f)), 2147483647i, (_e1317 > 2147483500f)), (_e1317 == _e1317));
let _e1328 = (_e1324 - select(0i, 1i, (_e1317 < f32(_e1324))));
let _e1329 = f32(_e1328);
let _e1333 = ((_e1311 - (_e1329 * 0.6933594f)) - (_e1329 * -2.1219444e-4f));
let _e1354 = (_e1098 + 3i);
let _e1356 = select(_e772, _e1354, (_e1354 < _e772));
let _e1362 = global_4.member[bitcast<u32>(select(0i, _e1356, (_e1356 > 0i)))];
let _e1364 = -((_e1362 * _e1216));
let _e1366 = select(-87f, _e1364, (_e1364 > -87f));
let _e1368 = select(88f, _e1366, (_e1366 < 88f));
let _e1370 = ((_e1368 * 1.442695f) + 0.5f);
let _e1372 = select(-127f, _e1370, (_e1370 > -127f));
let _e1374 = select(128f, _e1372, (_e1372 < 128f));
let _e1381 = select(0i, select(select(i32(_e1374), i32(-2147483648), (_e1374 < -2147483600f)), 2147483647i, (_e1374 > 2147483500f)), (_e1374 == _e1374));
let _e1385 = (_e1381 - select(0i, 1i, (_e1374 < f32(_e1381))));
let _e1386 = f32(_e1385);
let _e1390 = ((_e1368 - (_e1386 * 0.6933594f)) - (_e1386 * -2.1219444e-4f));
phi_3888_ = type_25(_e1239.member, _e1239.member_1, vec3<f32>((_e686.member_2.x * ((1f + (_e1276 * (1f + (_e1276 * (0.5f + (_e1276 * (0.16666667f + (_e1276 * (0.041666668f + (_e1276 * (0.008333334f + (_e1276 * (0.001388889f + (_e1276 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1271 + 127i)) << bitcast<u32>(23i))))), (_e686.member_2.y * ((1f + (_e1333 * (1f + (_e1333 * (0.5f + (_e1333 * (0.16666667f + (_e1333 * (0.041666668f + (_e1333 * (0.008333334f + (_e1333 * (0.001388889f + (_e1333 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1328 + 127i)) << bitcast<u32>(23i))))), (_e686.member_2.z * ((1f + (_e1390 * (1f + (_e1390 * (0.5f + (_e1390 * (0.16666667f + (_e1390 * (0.041666668f + (_e1390 * (0.008333334f + (_e1390 * (0.001388889f + (_e1390 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1385 + 127i)) << bitcast<u32>(23i)))))), _e1239.member_3, _e1239.member_4, _e1239.member_5, _e1239.member_6, _e1239.member_7, _e1239.member_8, _e1239.member_9, _e1239.member_10, _e1239.member_11, _e1239.member_12, _e1239.member_13, _e1239.member_14, _e1239.member_15, _e1239.member_16, _e1239.member_17);
} else {
phi_3888_ = _e686;
}
let _e1440 = phi_3888_;
let _e1476 = type_25(vec3<f32>((_e1440.member.x + (_e1440.member_1.x * _e1440.member_17)), (_e1440.member.y + (_e1440.member_1.y * _e1440.member_17)), (_e1440.member.z + (_e1440.member_1.z * _e1440.member_17))), _e1440.member_1, _e1440.member_2, _e1440.member_3, _e1440.member_4, _e1440.member_5, _e1440.member_6, _e1440.member_7, _e1440.member_8, _e1440.member_9, _e1440.member_10, _e1440.member_11, _e1440.member_12, _e1440.member_13, _e1440.member_14, _e1440.member_15, _e1440.member_16, _e1440.member_17);
let _e1496 = type_25(_e1476.member, _e1476.member_1, _e1476.member_2, _e1476.member_3, _e1476.member_4, (_e1440.member_5 + _e1440.member_17), _e1476.member_6, _e1476.member_7, _e1476.member_8, _e1476.member_9, _e1476.member_10, _e1476.member_11, _e1476.member_12, _e1476.member_13, _e1476.member_14, _e1476.member_15, _e1476.member_16, _e1476.member_17);
let _e1498 = (_e1440.member_8 == 0f);
let _e1519 = type_25(_e1496.member, _e1496.member_1, _e1496.member_2, _e1496.member_3, _e1496.member_4, _e1496.member_5, _e1496.member_6, _e1496.member_7, _e1496.member_8, _e1496.member_9, (_e1440.member_10 + select(0f, _e1440.member_17, _e1498)), _e1496.member_11, _e1496.member_12, _e1496.member_13, _e1496.member_14, _e1496.member_15, _e1496.member_16, _e1496.member_17);
let _e1524 = type_26(0i, _e684.member_1, _e684.member_2, _e684.member_3, _e684.member_4);
let _e1529 = type_26(_e1524.member, 0i, _e1524.member_2, _e1524.member_3, _e1524.member_4);
let _e1541 = select(1f, -1f, ((((_e1440.member_1.x * _e1208) + (_e1440.member_1.y * _e1209)) + (_e1440.member_1.z * _e1210)) > 0f));
let _e1542 = (_e1208 * _e1541);
let _e1543 = (_e1209 * _e1541);
let _e1544 = (_e1210 * _e1541);
let _e1550 = -((((_e1440.member_1.x * _e1542) + (_e1440.member_1.y * _e1543)) + (_e1440.member_1.z * _e1544)));
let _e1552 = select(0f, _e1550, (_e1550 > 0f));
let _e1553 = (_e1552 * _e1552);
let _e1556 = (1f - (_e1142 * (1f - _e1553)));
let _e1557 = (_e1556 <= 0f);
let _e1565 = ((_e1141 * _e1552) - sqrt(select(0f, _e1556, (_e1556 > 0f))));
let _e1572 = (2f * _e1552);
let _e1576 = (_e1440.member_1.x + (_e1542 * _e1572));
let _e1577 = (_e1440.member_1.y + (_e1543 * _e1572));
let _e1578 = (_e1440.member_1.z + (_e1544 * _e1572));
let _e1579 = select(((_e1440.member_1.x * _e1141) + (_e1542 * _e1565)), _e1576, _e1557);
let _e1580 = select(((_e1440.member_1.y * _e1141) + (_e1543 * _e1565)), _e1577, _e1557);
let _e1581 = select(((_e1440.member_1.z * _e1141) + (_e1544 * _e1565)), _e1578, _e1557);
let _e1586 = (((_e1579 * _e1579) + (_e1580 * _e1580)) + (_e1581 * _e1581));
let _e1589 = sqrt(select(0f, _e1586, (_e1586 > 0f)));
let _e1592 = (1f / select(1e-20f, _e1589, (_e1589 > 1e-20f)));
let _e1597 = (_e1122 / _e1107);
let _e1600 = (((_e1597 * _e1597) - 1f) + _e1553);
let _e1603 = sqrt(select(0f, _e1600, (_e1600 > 0f)));
let _e1604 = (_e1603 - _e1552);
let _e1605 = (_e1603 + _e1552);
let _e1608 = (_e1604 / select(1e-6f, _e1605, (_e1605 > 1e-6f)));
let _e1612 = ((_e1552 * _e1604) + 1f);
let _e1615 = (((_e1552 * _e1605) - 1f) / select(1e-6f, _e1612, (_e1612 > 1e-6f)));
let _e1627 = global_1.member.member_1;
let _e1630 = select(0f, select(select((((0.5f * _e1608) * _e1608) * (1f + (_e1615 * _e1615))), 1f, (_e1600 <= 0f)), 0f, (_e1107 == _e1122)), ((_e1627 & 1u) != 0u));
let _e1631 = (_e1498 && _e747);
if _e1498 {
let _e1649 = type_25(_e1519.member, _e1519.member_1, _e1519.member_2, vec3<f32>(_e1208, _e1209, _e1210), _e1519.member_4, _e1519.member_5, _e1519.member_6, _e1519.member_7, _e1519.member_8, _e1519.member_9, _e1519.member_10, _e1519.member_11, _e1519.member_12, _e1519.member_13, _e1519.member_14, _e1519.member_15, _e1519.member_16, _e1519.member_17);
phi_4394_ = type_25(_e1649.member, _e1649.member_1, _e1649.member_2, _e1649.member_3, _e1649.member_4, _e1649.member_5, _e1649.member_6, _e1649.member_7, _e1649.member_8, _e1649.member_9, _e1649.member_10, select(0f, _e1630, _e1631), _e1649.member_12, _e1649.member_13, _e1649.member_14, _e1649.member_15, _e1649.member_16, _e1649.member_17);
} else {
phi_4394_ = _e1519;
}
let _e1670 = phi_4394_;
let _e1674 = select(24f, _e1670.member_8, (_e1670.member_8 < 24f));
let _e1684 = (_e1670.member_14 >> bitcast<u32>((select(0i, select(select(i32(_e1674), i32(-2147483648), (_e1674 < -2147483600f)), 2147483647i, (_e1674 > 2147483500f)), (_e1674 == _e1674)) & 31i)));
let _e1686 = ((_e1684 & 1i) == 1i);
if ((!(_e1631) && !(_e1557)) && (_e1684 == 0i)) {
let _e1695 = select(_e1670.member_5, _e1670.member_9, (_e1670.member_8 == 0f));
let _e1696 = (_e1098 + 1i);
let _e1698 = select(_e772, _e1696, (_e1696 < _e772));
let _e1704 = global_4.member[bitcast<u32>(select(0i, _e1698, (_e1698 > 0i)))];
let _e1706 = -((_e1704 * _e1695));
let _e1708 = select(-87f, _e1706, (_e1706 > -87f));
let _e1710 = select(88f, _e1708, (_e1708 < 88f));
let _e1712 = ((_e1710 * 1.442695f) + 0.5f);
let _e1714 = select(-127f, _e1712, (_e1712 > -127f));
let _e1716 = select(128f, _e1714, (_e1714 < 128f));
let _e1723 = select(0i, select(select(i32(_e1716), i32(-2147483648), (_e1716 < -2147483600f)), 2147483647i, (_e1716 > 2147483500f)), (_e1716 == _e1716));
let _e1727 = (_e1723 - select(0i, 1i, (_e1716 < f32(_e1723))));
let _e1728 = f32(_e1727);
let _e1732 = ((_e1710 - (_e1728 * 0.6933594f)) - (_e1728 * -2.1219444e-4f));
let _e1753 = (_e1098 + 2i);
let _e1755 = select(_e772, _e1753, (_e1753 < _e772));
let _e1761 = global_4.member[bitcast<u32>(select(0i, _e1755, (_e1755 > 0i)))];
let _e1763 = -((_e1761 * _e1695));
let _e1765 = select(-87f, _e1763, (_e1763 > -87f));
let _e1767 = select(88f, _e1765, (_e1765 < 88f));
let _e1769 = ((_e1767 * 1.442695f) + 0.5f);
let _e1771 = select(-127f, _e1769, (_e1769 > -127f));
let _e1773 = select(128f, _e1771, (_e1771 < 128f));
let _e1780 = select(0i, select(select(i32(_e1773), i32(-2147483648), (_e1773 < -2147483600f)), 2147483647i, (_e1773 > 2147483500f)), (_e1773 == _e1773));
let _e1784 = (_e1780 - select(0i, 1i, (_e1773 < f32(_e1780))));
let _e1785 = f32(_e1784);
let _e1789 = ((_e1767 - (_e1785 * 0.6933594f)) - (_e1785 * -2.1219444e-4f));
let _e1810 = (_e1098 + 3i);
let _e1812 = select(_e772, _e1810, (_e1810 < _e772));
let _e1818 = global_4.member[bitcast<u32>(select(0i, _e1812, (_e1812 > 0i)))];
let _e1820 = -((_e1818 * _e1695));
let _e1822 = select(-87f, _e1820, (_e1820 > -87f));
let _e1824 = select(88f, _e1822, (_e1822 < 88f));
let _e1826 = ((_e1824 * 1.442695f) + 0.5f);
let _e1828 = select(-127f, _e1826, (_e1826 > -127f));
let _e1830 = select(128f, _e1828, (_e1828 < 128f));
let _e1837 = select(0i, select(select(i32(_e1830), i32(-2147483648), (_e1830 < -2147483600f)), 2147483647i, (_e1830 > 2147483500f)), (_e1830 == _e1830));
let _e1841 = (_e1837 - select(0i, 1i, (_e1830 < f32(_e1837))));
let _e1842 = f32(_e1841);
let _e1846 = ((_e1824 - (_e1842 * 0.6933594f)) - (_e1842 * -2.1219444e-4f));
let _e1868 = select(((1f + (_e1732 * (1f + (_e1732 * (0.5f + (_e1732 * (0.16666667f + (_e1732 * (0.041666668f + (_e1732 * (0.008333334f + (_e1732 * (0.001388889f + (_e1732 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1727 + 127i)) << bitcast<u32>(23i)))), 1f, _e747);
let _e1870 = (1f - (_e1630 * _e1868));
let _e1872 = (1f - _e1630);
let _e1878 = select(((1f + (_e1789 * (1f + (_e1789 * (0.5f + (_e1789 * (0.16666667f + (_e1789 * (0.041666668f + (_e1789 * (0.008333334f + (_e1789 * (0.001388889f + (_e1789 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1784 + 127i)) << bitcast<u32>(23i)))), 1f, _e747);
let _e1880 = (1f - (_e1630 * _e1878));
let _e1887 = select(((1f + (_e1846 * (1f + (_e1846 * (0.5f + (_e1846 * (0.16666667f + (_e1846 * (0.041666668f + (_e1846 * (0.008333334f + (_e1846 * (0.001388889f + (_e1846 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1841 + 127i)) << bitcast<u32>(23i)))), 1f, _e747);
let _e1889 = (1f - (_e1630 * _e1887));
let _e1902 = ((_e1670.member_2.x * select(1f, ((_e1872 * _e1868) / select(1e-9f, _e1870, (_e1870 > 1e-9f))), (_e1870 > 0f))) * _e1630);
let _e1903 = ((_e1670.member_2.y * select(1f, ((_e1872 * _e1878) / select(1e-9f, _e1880, (_e1880 > 1e-9f))), (_e1880 > 0f))) * _e1630);
let _e1904 = ((_e1670.member_2.z * select(1f, ((_e1872 * _e1887) / select(1e-9f, _e1889, (_e1889 > 1e-9f))), (_e1889 > 0f))) * _e1630);
let _e1912 = select(0i, select(select(i32(_e1670.member_8), i32(-2147483648), (_e1670.member_8 < -2147483600f)), 2147483647i, (_e1670.member_8 > 2147483500f)), (_e1670.member_8 == _e1670.member_8));
let _e1924 = ((_e1670.member_13.x + _e1670.member_13.y) + _e1670.member_13.z);
if ((((_e1627 & 8u) != 0u) && (_e1912 < 24i)) && (((_e1902 + _e1903) + _e1904) > _e1924)) {
if (_e1924 > 0f) {
if (_e1670.member_14 == 0i) {
phi_4792_ = 0i;
} else {
phi_4792_ = (_e1670.member_14 - (1i << bitcast<u32>(((bitcast<i32>((bitcast<u32>(f32(_e1670.member_14)) >> bitcast<u32>(23i))) - 127i) & 31i))));
}
let _e1968 = phi_4792_;
phi_4794_ = _e1968;
} else {
phi_4794_ = _e1670.member_14;
}
let _e1970 = phi_4794_;
let _e1992 = type_25(_e1670.member, _e1670.member_1, _e1670.member_2, _e1670.member_3, _e1670.member_4, _e1670.member_5, _e1670.member_6, _e1670.member_7, _e1670.member_8, _e1670.member_9, _e1670.member_10, _e1670.member_11, _e1670.member_12, _e1670.member_13, (_e1970 | (1i << bitcast<u32>((_e1912 & 31i)))), _e1670.member_15, _e1670.member_16, _e1670.member_17);
let _e2020 = type_25(_e1992.member, _e1992.member_1, _e1992.member_2, _e1992.member_3, _e1992.member_4, _e1992.member_5, _e1992.member_6, _e1992.member_7, _e1992.member_8, _e1992.member_9, _e1992.member_10, _e1992.member_11, vec3<f32>((_e1670.member_12.x + _e1670.member_13.x), (_e1670.member_12.y + _e1670.member_13.y), (_e1670.member_12.z + _e1670.member_13.z)), _e1992.member_13, _e1992.member_14, _e1992.member_15, _e1992.member_16, _e1992.member_17);
phi_4822_ = type_25(_e2020.member, _e2020.member_1, _e2020.member_2, _e2020.member_3, _e2020.member_4, _e2020.member_5, _e2020.member_6, _e2020.member_7, _e2020.member_8, _e2020.member_9, _e2020.member_10, _e2020.member_11, _e2020.member_12, vec3<f32>(_e1902, _e1903, _e1904), _e2020.member_14, _e2020.member_15, _e2020.member_16, _e2020.member_17);
} else {
phi_4822_ = type_25(_e1670.member, _e1670.member_1, _e1670.member_2, _e1670.member_3, _e1670.member_4, _e1670.member_5, _e1670.member_6, _e1670.member_7, _e1670.member_8, _e1670.member_9, _e1670.member_10, _e1670.member_11, vec3<f32>((_e1670.member_12.x + _e1902), (_e1670.member_12.y + _e1903), (_e1670.member_12.z + _e1904)), _e1670.member_13, _e1670.member_14, _e1670.member_15, _e1670.member_16, _e1670.member_17);
}
let _e2040 = phi_4822_;
phi_4823_ = _e2040;
} else {
phi_4823_ = _e1670;
}
let _e2042 = phi_4823_;
let _e2044 = (_e2042.member_8 + 1f);
let _e2062 = type_25(_e2042.member, _e2042.member_1, _e2042.member_2, _e2042.member_3, _e2042.member_4, _e2042.member_5, _e2042.member_6, _e2042.member_7, _e2044, _e2042.member_9, _e2042.member_10, _e2042.member_11, _e2042.member_12, _e2042.member_13, _e2042.member_14, _e2042.member_15, _e2042.member_16, _e2042.member_17);
let _e2066 = !(_e1686);
let _e2067 = (((_e119.member_2 == 0u) && (_e2044 >= 2f)) && _e2066);
if (_e1557 && _e2067) {
let _e2130 = (((_e2042.member_1.x * _e1208) + (_e2042.member_1.y * _e1209)) + (_e2042.member_1.z * _e1210));
let _e2134 = (_e2042.member_1.x - (_e1208 * _e2130));
let _e2135 = (_e2042.member_1.y - (_e1209 * _e2130));
let _e2136 = (_e2042.member_1.z - (_e1210 * _e2130));
let _e2141 = (((_e2134 * _e2134) + (_e2135 * _e2135)) + (_e2136 * _e2136));
let _e2144 = sqrt(select(0f, _e2141, (_e2141 > 0f)));
let _e2147 = (1f / select(1e-20f, _e2144, (_e2144 > 1e-20f)));
phi_4904_ = type_25(_e2062.member, vec3<f32>((_e2134 * _e2147), (_e2135 * _e2147), (_e2136 * _e2147)), _e2062.member_2, _e2062.member_3, _e2062.member_4, _e2062.member_5, _e2062.member_6, _e2062.member_7, _e2062.member_8, _e2062.member_9, _e2062.member_10, _e2062.member_11, _e2062.member_12, _e2062.member_13, _e2062.member_14, _e2062.member_15, _e2062.member_16, _e2062.member_17);
} else {
if _e1686 {
let _e2091 = (((_e1576 * _e1576) + (_e1577 * _e1577)) + (_e1578 * _e1578));
let _e2094 = sqrt(select(0f, _e2091, (_e2091 > 0f)));
let _e2097 = (1f / select(1e-20f, _e2094, (_e2094 > 1e-20f)));
phi_4903_ = type_25(_e2062.member, vec3<f32>((_e1576 * _e2097), (_e1577 * _e2097), (_e1578 * _e2097)), _e2062.member_2, _e2062.member_3, _e2062.member_4, _e2062.member_5, _e2062.member_6, _e2062.member_7, _e2062.member_8, _e2062.member_9, _e2062.member_10, _e2062.member_11, _e2062.member_12, _e2062.member_13, _e2062.member_14, _e2062.member_15, _e2062.member_16, _e2062.member_17);
} else {
phi_4903_ = type_25(_e2062.member, vec3<f32>((_e1579 * _e1592), (_e1580 * _e1592), (_e1581 * _e1592)), _e2062.member_2, _e2062.member_3, _e2062.member_4, _e2062.member_5, _e2062.member_6, _e2062.member_7, _e2062.member_8, _e2062.member_9, _e2062.member_10, _e2062.member_11, _e2062.member_12, _e2062.member_13, _e2062.member_14, _e2062.member_15, _e2062.member_16, _e2062.member_17);
}
let _e2121 = phi_4903_;
phi_4904_ = _e2121;
}
let _e2171 = phi_4904_;
if _e1557 {
phi_4922_ = _e2171;
} else {
let _e2173 = select((1f - _e1630), _e1630, _e1686);
phi_4922_ = type_25(_e2171.member, _e2171.member_1, vec3<f32>((_e2171.member_2.x * _e2173), (_e2171.member_2.y * _e2173), (_e2171.member_2.z * _e2173)), _e2171.member_3, _e2171.member_4, _e2171.member_5, _e2171.member_6, _e2171.member_7, _e2171.member_8, _e2171.member_9, _e2171.member_10, _e2171.member_11, _e2171.member_12, _e2171.member_13, _e2171.member_14, _e2171.member_15, _e2171.member_16, _e2171.member_17);
}
let _e2203 = phi_4922_;
let _e2221 = type_25(_e2203.member, _e2203.member_1, _e2203.member_2, _e2203.member_3, _e2203.member_4, 0f, _e2203.member_6, _e2203.member_7, _e2203.member_8, _e2203.member_9, _e2203.member_10, _e2203.member_11, _e2203.member_12, _e2203.member_13, _e2203.member_14, _e2203.member_15, _e2203.member_16, _e2203.member_17);
let _e2228 = global_1.member.member_18.member.member;
let _e2242 = ((((_e2228.member.member * _e2203.member.x) + (_e2228.member.member_1 * _e2203.member.y)) + (_e2228.member.member_2 * _e2203.member.z)) + _e2228.member_1);
let _e2251 = -((((_e2228.member.member * _e2203.member_1.x) + (_e2228.member.member_1 * _e2203.member_1.y)) + (_e2228.member.member_2 * _e2203.member_1.z)));
let _e2253 = (_e2251 > 1e-9f);
let _e2257 = ((_e2242 / select(1e-9f, _e2251, _e2253)) - 0.015625f);
let _e2260 = select(1e30f, select(0f, _e2257, (_e2257 > 0f)), ((_e2242 > 0f) && _e2253));
let _e2265 = global_1.member.member_18.member_1.member;
let _e2276 = ((((_e2265.member.member * _e2203.member.x) + (_e2265.member.member_1 * _e2203.member.y)) + (_e2265.member.member_2 * _e2203.member.z)) + _e2265.member_1);
let _e2282 = -((((_e2265.member.member * _e2203.member_1.x) + (_e2265.member.member_1 * _e2203.member_1.y)) + (_e2265.member.member_2 * _e2203.member_1.z)));
let _e2284 = (_e2282 > 1e-9f);
let _e2288 = ((_e2276 / select(1e-9f, _e2282, _e2284)) - 0.015625f);
let _e2291 = select(1e30f, select(0f, _e2288, (_e2288 > 0f)), ((_e2276 > 0f) && _e2284));
let _e2295 = (_e2291 < _e2260);
let _e2297 = select(select(-2i, -3i, _e2295), -1i, ((_e2260 >= 1e30f) && (_e2291 >= 1e30f)));
let _e2298 = select(_e2260, _e2291, _e2295);
let _e2316 = type_25(_e2221.member, _e2221.member_1, _e2221.member_2, _e2221.member_3, _e2221.member_4, _e2221.member_5, _e2221.member_6, _e2221.member_7, _e2221.member_8, _e2221.member_9, _e2221.member_10, _e2221.member_11, _e2221.member_12, _e2221.member_13, _e2221.member_14, 0i, _e2221.member_16, _e2221.member_17);
let _e2334 = type_25(_e2316.member, _e2316.member_1, _e2316.member_2, _e2316.member_3, _e2316.member_4, _e2316.member_5, _e2316.member_6, _e2316.member_7, _e2316.member_8, _e2316.member_9, _e2316.member_10, _e2316.member_11, _e2316.member_12, _e2316.member_13, _e2316.member_14, _e2316.member_15, _e2297, _e2316.member_17);
let _e2352 = type_25(_e2334.member, _e2334.member_1, _e2334.member_2, _e2334.member_3, _e2334.member_4, _e2334.member_5, _e2334.member_6, _e2334.member_7, _e2334.member_8, _e2334.member_9, _e2334.member_10, _e2334.member_11, _e2334.member_12, _e2334.member_13, _e2334.member_14, _e2334.member_15, _e2334.member_16, _e2298);
let _e2353 = (_e1557 || _e1686);
let _e2355 = local_7;
let _e2357 = local_8;
let _e2360 = ((_e1627 & 2u) != 0u);
if (_e2067 && !(_e2360)) {
if (_e2297 == -1i) {
phi_5349_ = type_25(_e2352.member, _e2352.member_1, _e2352.member_2, _e2352.member_3, _e2352.member_4, _e2352.member_5, 1f, _e2352.member_7, _e2352.member_8, _e2352.member_9, _e2352.member_10, _e2352.member_11, _e2352.member_12, _e2352.member_13, _e2352.member_14, _e2352.member_15, _e2352.member_16, _e2352.member_17);
} else {
let _e2446 = type_25(vec3<f32>((_e2203.member.x + (_e2203.member_1.x * _e2298)), (_e2203.member.y + (_e2203.member_1.y * _e2298)), (_e2203.member.z + (_e2203.member_1.z * _e2298))), _e2352.member_1, _e2352.member_2, _e2352.member_3, _e2352.member_4, _e2352.member_5, _e2352.member_6, _e2352.member_7, _e2352.member_8, _e2352.member_9, _e2352.member_10, _e2352.member_11, _e2352.member_12, _e2352.member_13, _e2352.member_14, _e2352.member_15, _e2352.member_16, _e2352.member_17);
let _e2465 = type_25(_e2446.member, _e2446.member_1, _e2446.member_2, _e2446.member_3, _e2446.member_4, (0f + _e2298), _e2446.member_6, _e2446.member_7, _e2446.member_8, _e2446.member_9, _e2446.member_10, _e2446.member_11, _e2446.member_12, _e2446.member_13, _e2446.member_14, _e2446.member_15, _e2446.member_16, _e2446.member_17);
let _e2484 = type_25(_e2465.member, _e2465.member_1, _e2465.member_2, _e2465.member_3, _e2465.member_4, _e2465.member_5, _e2465.member_6, _e2465.member_7, _e2465.member_8, _e2465.member_9, _e2465.member_10, _e2465.member_11, _e2465.member_12, _e2465.member_13, _e2465.member_14, _e2465.member_15, _e2465.member_16, (_e2298 - _e2298));
let _e2507 = type_25(_e2484.member, _e2484.member_1, _e2484.member_2, _e2484.member_3, _e2484.member_4, _e2484.member_5, _e2484.member_6, _e2484.member_7, _e2484.member_8, _e2484.member_9, (_e2203.member_10 + select(0f, _e2298, (_e2203.member_8 == 0f))), _e2484.member_11, _e2484.member_12, _e2484.member_13, _e2484.member_14, _e2484.member_15, _e2484.member_16, _e2484.member_17);
phi_5349_ = type_25(_e2507.member, _e2507.member_1, _e2507.member_2, _e2507.member_3, _e2507.member_4, _e2507.member_5, 3f, _e2507.member_7, _e2507.member_8, _e2507.member_9, _e2507.member_10, _e2507.member_11, _e2507.member_12, _e2507.member_13, _e2507.member_14, _e2507.member_15, _e2507.member_16, _e2507.member_17);
}
let _e2545 = phi_5349_;
phi_5372_ = _e2545;
} else {
let _e2368 = global_1.member.member_5;
if (((!(_e2067) && _e2066) && (_e2203.member_8 >= f32(bitcast<i32>(_e2368)))) && (select(_e2357, _e2355, _e2353) != 16i)) {
phi_5371_ = type_25(_e2352.member, _e2352.member_1, _e2352.member_2, _e2352.member_3, _e2352.member_4, _e2352.member_5, 2f, _e2352.member_7, _e2352.member_8, _e2352.member_9, _e2352.member_10, _e2352.member_11, _e2352.member_12, _e2352.member_13, _e2352.member_14, _e2352.member_15, _e2352.member_16, _e2352.member_17);
} else {
if _e2360 {
phi_5370_ = type_25(_e2352.member, _e2352.member_1, _e2352.member_2, _e2352.member_3, _e2352.member_4, _e2352.member_5, 4f, _e2352.member_7, _e2352.member_8, _e2352.member_9, _e2352.member_10, _e2352.member_11, _e2352.member_12, _e2352.member_13, _e2352.member_14, _e2352.member_15, _e2352.member_16, _e2352.member_17);
} else {
phi_5370_ = _e2352;
}
let _e2394 = phi_5370_;
phi_5371_ = _e2394;
}
let _e2414 = phi_5371_;
phi_5372_ = _e2414;
}
let _e2547 = phi_5372_;
phi_5378_ = type_26(_e1529.member, _e1529.member_1, 0f, _e1529.member_3, _e1529.member_4);
phi_5379_ = _e2547;
phi_5380_ = select(_e690, _e725, !(_e2353));
}
let _e2931 = phi_5378_;
let _e2933 = phi_5379_;
let _e2935 = phi_5380_;
phi_5381_ = _e2931;
phi_5382_ = _e2933;
phi_5383_ = _e2935;
}
let _e2937 = phi_5381_;
let _e2939 = phi_5382_;
let _e2941 = phi_5383_;
phi_5385_ = _e2937;
phi_5386_ = _e2939;
phi_5387_ = _e2941;
phi_5389_ = select(true, false, _e783);
}
let _e2944 = phi_5385_;
let _e2946 = phi_5386_;
let _e2948 = phi_5387_;
let _e2950 = phi_5389_;
phi_5400_ = _e2944;
phi_5401_ = _e2946;
phi_5402_ = _e2948;
phi_5404_ = select(_e783, false, _e749);
phi_5405_ = _e2950;
} else {
phi_5400_ = type_26();
phi_5401_ = type_25();
phi_5402_ = i32();
phi_5404_ = select(true, false, _e749);
phi_5405_ = false;
}
let _e2953 = phi_5400_;
let _e2955 = phi_5401_;
let _e2957 = phi_5402_;
let _e2959 = phi_5404_;
let _e2961 = phi_5405_;
if _e749 {
if _e744 {
phi_5702_ = type_25(_e686.member, _e686.member_1, _e686.member_2, _e686.member_3, _e686.member_4, _e686.member_5, 1f, _e686.member_7, _e686.member_8, _e686.member_9, _e686.member_10, _e686.member_11, _e686.member_12, _e686.member_13, _e686.member_14, _e686.member_15, _e686.member_16, _e686.member_17);
} else {
let _e2997 = type_25(vec3<f32>((_e686.member.x + (_e686.member_1.x * _e686.member_17)), (_e686.member.y + (_e686.member_1.y * _e686.member_17)), (_e686.member.z + (_e686.member_1.z * _e686.member_17))), _e686.member_1, _e686.member_2, _e686.member_3, _e686.member_4, _e686.member_5, _e686.member_6, _e686.member_7, _e686.member_8, _e686.member_9, _e686.member_10, _e686.member_11, _e686.member_12, _e686.member_13, _e686.member_14, _e686.member_15, _e686.member_16, _e686.member_17);
let _e3017 = type_25(_e2997.member, _e2997.member_1, _e2997.member_2, _e2997.member_3, _e2997.member_4, (_e686.member_5 + _e686.member_17), _e2997.member_6, _e2997.member_7, _e2997.member_8, _e2997.member_9, _e2997.member_10, _e2997.member_11, _e2997.member_12, _e2997.member_13, _e2997.member_14, _e2997.member_15, _e2997.member_16, _e2997.member_17);
let _e3036 = type_25(_e3017.member, _e3017.member_1, _e3017.member_2, _e3017.member_3, _e3017.member_4, _e3017.member_5, _e3017.member_6, _e3017.member_7, _e3017.member_8, _e3017.member_9, _e3017.member_10, _e3017.member_11, _e3017.member_12, _e3017.member_13, _e3017.member_14, _e3017.member_15, _e3017.member_16, (_e686.member_17 - _e686.member_17));
let _e3059 = type_25(_e3036.member, _e3036.member_1, _e3036.member_2, _e3036.member_3, _e3036.member_4, _e3036.member_5, _e3036.member_6, _e3036.member_7, _e3036.member_8, _e3036.member_9, (_e686.member_10 + select(0f, _e686.member_17, (_e686.member_8 == 0f))), _e3036.member_11, _e3036.member_12, _e3036.member_13, _e3036.member_14, _e3036.member_15, _e3036.member_16, _e3036.member_17);
phi_5702_ = type_25(_e3059.member, _e3059.member_1, _e3059.member_2, _e3059.member_3, _e3059.member_4, _e3059.member_5, 3f, _e3059.member_7, _e3059.member_8, _e3059.member_9, _e3059.member_10, _e3059.member_11, _e3059.member_12, _e3059.member_13, _e3059.member_14, _e3059.member_15, _e3059.member_16, _e3059.member_17);
}
let _e3097 = phi_5702_;
phi_5703_ = _e3097;
} else {
phi_5703_ = type_25();
}
let _e3099 = phi_5703_;
let _e3100 = select(_e2959, false, _e749);
if _e3100 {
let _e3104 = (_e686.member_17 - _e684.member_2);
let _e3106 = select(0f, _e3104, (_e3104 > 0f));
let _e3108 = local_11;
if (_e3108 != 16i) {
let _e3129 = type_25(_e686.member, _e686.member_1, _e686.member_2, _e686.member_3, _e686.member_4, _e686.member_5, _e686.member_6, _e686.member_7, _e686.member_8, (_e686.member_9 + _e3106), _e686.member_10, _e686.member_11, _e686.member_12, _e686.member_13, _e686.member_14, _e686.member_15, _e686.member_16, _e686.member_17);
let _e3131 = local_12;
let _e3132 = (_e3131 * 4i);
let _e3133 = (_e3132 + 1i);
let _e3135 = (bitcast<i32>(_e112) - 1i);
let _e3137 = select(_e3135, _e3133, (_e3133 < _e3135));
let _e3143 = global_4.member[bitcast<u32>(select(0i, _e3137, (_e3137 > 0i)))];
let _e3145 = -((_e3143 * _e3106));
let _e3147 = select(-87f, _e3145, (_e3145 > -87f));
let _e3149 = select(88f, _e3147, (_e3147 < 88f));
let _e3151 = ((_e3149 * 1.442695f) + 0.5f);
let _e3153 = select(-127f, _e3151, (_e3151 > -127f));
let _e3155 = select(128f, _e3153, (_e3153 < 128f));
let _e3162 = select(0i, select(select(i32(_e3155), i32(-2147483648), (_e3155 < -2147483600f)), 2147483647i, (_e3155 > 2147483500f)), (_e3155 == _e3155));
let _e3166 = (_e3162 - select(0i, 1i, (_e3155 < f32(_e3162))));
let _e3167 = f32(_e3166);
let _e3171 = ((_e3149 - (_e3167 * 0.6933594f)) - (_e3167 * -2.1219444e-4f));
let _e3192 = (_e3132 + 2i);
let _e3194 = select(_e3135, _e3192, (_e3192 < _e3135));
let _e3200 = global_4.member[bitcast<u32>(select(0i, _e3194, (_e3194 > 0i)))];
let _e3202 = -((_e3200 * _e3106));
let _e3204 = select(-87f, _e3202, (_e3202 > -87f));
let _e3206 = select(88f, _e3204, (_e3204 < 88f));
let _e3208 = ((_e3206 * 1.442695f) + 0.5f);
let _e3210 = select(-127f, _e3208, (_e3208 > -127f));
let _e3212 = select(128f, _e3210, (_e3210 < 128f));
let _e3219 = select(0i, select(select(i32(_e3212), i32(-2147483648), (_e3212 < -2147483600f)), 2147483647i, (_e3212 > 2147483500f)), (_e3212 == _e3212));
let _e3223 = (_e3219 - select(0i, 1i, (_e3212 < f32(_e3219))));
let _e3224 = f32(_e3223);
let _e3228 = ((_e3206 - (_e3224 * 0.6933594f)) - (_e3224 * -2.1219444e-4f));
let _e3249 = (_e3132 + 3i);
let _e3251 = select(_e3135, _e3249, (_e3249 < _e3135));
let _e3257 = global_4.member[bitcast<u32>(select(0i, _e3251, (_e3251 > 0i)))];
let _e3259 = -((_e3257 * _e3106));
let _e3261 = select(-87f, _e3259, (_e3259 > -87f));
let _e3263 = select(88f, _e3261, (_e3261 < 88f));
let _e3265 = ((_e3263 * 1.442695f) + 0.5f);
let _e3267 = select(-127f, _e3265, (_e3265 > -127f));
let _e3269 = select(128f, _e3267, (_e3267 < 128f));
let _e3276 = select(0i, select(select(i32(_e3269), i32(-2147483648), (_e3269 < -2147483600f)), 2147483647i, (_e3269 > 2147483500f)), (_e3269 == _e3269));
let _e3280 = (_e3276 - select(0i, 1i, (_e3269 < f32(_e3276))));
let _e3281 = f32(_e3280);
let _e3285 = ((_e3263 - (_e3281 * 0.6933594f)) - (_e3281 * -2.1219444e-4f));
phi_5970_ = type_25(_e3129.member, _e3129.member_1, vec3<f32>((_e686.member_2.x * ((1f + (_e3171 * (1f + (_e3171 * (0.5f + (_e3171 * (0.16666667f + (_e3171 * (0.041666668f + (_e3171 * (0.008333334f + (_e3171 * (0.001388889f + (_e3171 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3166 + 127i)) << bitcast<u32>(23i))))), (_e686.member_2.y * ((1f + (_e3228 * (1f + (_e3228 * (0.5f + (_e3228 * (0.16666667f + (_e3228 * (0.041666668f + (_e3228 * (0.008333334f + (_e3228 * (0.001388889f + (_e3228 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3223 + 127i)) << bitcast<u32>(23i))))), (_e686.member_2.z * ((1f + (_e3285 * (1f + (_e3285 * (0.5f + (_e3285 * (0.16666667f + (_e3285 * (0.041666668f + (_e3285 * (0.008333334f + (_e3285 * (0.001388889f + (_e3285 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3280 + 127i)) << bitcast<u32>(23i)))))), _e3129.member_3, _e3129.member_4, _e3129.member_5, _e3129.member_6, _e3129.member_7, _e3129.member_8, _e3129.member_9, _e3129.member_10, _e3129.member_11, _e3129.member_12, _e3129.member_13, _e3129.member_14, _e3129.member_15, _e3129.member_16, _e3129.member_17);
} else {
phi_5970_ = _e686;
}
let _e3335 = phi_5970_;
let _e3371 = type_25(vec3<f32>((_e3335.member.x + (_e3335.member_1.x * _e3335.member_17)), (_e3335.member.y + (_e3335.member_1.y * _e3335.member_17)), (_e3335.member.z + (_e3335.member_1.z * _e3335.member_17))), _e3335.member_1, _e3335.member_2, _e3335.member_3, _e3335.member_4, _e3335.member_5, _e3335.member_6, _e3335.member_7, _e3335.member_8, _e3335.member_9, _e3335.member_10, _e3335.member_11, _e3335.member_12, _e3335.member_13, _e3335.member_14, _e3335.member_15, _e3335.member_16, _e3335.member_17);
let _e3391 = type_25(_e3371.member, _e3371.member_1, _e3371.member_2, _e3371.member_3, _e3371.member_4, (_e3335.member_5 + _e3335.member_17), _e3371.member_6, _e3371.member_7, _e3371.member_8, _e3371.member_9, _e3371.member_10, _e3371.member_11, _e3371.member_12, _e3371.member_13, _e3371.member_14, _e3371.member_15, _e3371.member_16, _e3371.member_17);
let _e3410 = type_25(_e3391.member, _e3391.member_1, _e3391.member_2, _e3391.member_3, _e3391.member_4, _e3391.member_5, _e3391.member_6, _e3391.member_7, _e3391.member_8, _e3391.member_9, _e3391.member_10, _e3391.member_11, _e3391.member_12, _e3391.member_13, _e3391.member_14, _e3391.member_15, _e3391.member_16, (_e3335.member_17 - _e3335.member_17));
let _e3433 = type_25(_e3410.member, _e3410.member_1, _e3410.member_2, _e3410.member_3, _e3410.member_4, _e3410.member_5, _e3410.member_6, _e3410.member_7, _e3410.member_8, _e3410.member_9, (_e3335.member_10 + select(0f, _e3335.member_17, (_e3335.member_8 == 0f))), _e3410.member_11, _e3410.member_12, _e3410.member_13, _e3410.member_14, _e3410.member_15, _e3410.member_16, _e3410.member_17);
phi_6258_ = _e684;
phi_6259_ = type_25(_e3433.member, _e3433.member_1, _e3433.member_2, _e3433.member_3, _e3433.member_4, _e3433.member_5, 3f, _e3433.member_7, _e3433.member_8, _e3433.member_9, _e3433.member_10, _e3433.member_11, _e3433.member_12, _e3433.member_13, _e3433.member_14, _e3433.member_15, _e3433.member_16, _e3433.member_17);
} else {
phi_6258_ = _e2953;
phi_6259_ = _e2955;
}
let _e3453 = phi_6258_;
let _e3455 = phi_6259_;
let _e3457 = select(select(_e2961, false, _e749), true, _e3100);
if _e3457 {
phi_6265_ = _e3453;
phi_6266_ = _e3455;
} else {
phi_6265_ = _e684;
phi_6266_ = _e3099;
}
let _e3459 = phi_6265_;
let _e3461 = phi_6266_;
phi_6268_ = _e3459;
phi_6269_ = _e3461;
phi_6270_ = select(_e690, select(_e2957, _e690, _e3100), _e3457);
}
let _e4099 = phi_6268_;
let _e4101 = phi_6269_;
let _e4103 = phi_6270_;
phi_1100_ = _e4099;
phi_1103_ = _e4101;
phi_1105_ = (_e688 + 1i);
phi_1107_ = _e4103;
} else {
phi_1100_ = type_26();
phi_1103_ = type_25();
phi_1105_ = i32();
phi_1107_ = i32();
}
let _e4105 = phi_1100_;
let _e4107 = phi_1103_;
let _e4109 = phi_1105_;
let _e4111 = phi_1107_;
continue;
continuing {
phi_1099_ = _e4105;
phi_1102_ = _e4107;
phi_1104_ = _e4109;
phi_1106_ = _e4111;
break if !(_e694);
}
}
let _e4114 = local_13;
if (_e4114 == 0i) {
phi_6276_ = 16i;
} else {
let _e4117 = local_14;
phi_6276_ = -(_e4117);
}
let _e4120 = phi_6276_;
let _e4122 = local_15;
let _e4126 = local_16;
let _e4130 = local_17;
let _e4133 = local_18;
let _e4136 = local_19;
let _e4140 = local_20;
let _e4144 = local_21;
let _e4148 = local_22;
let _e4152 = local_23;
let _e4156 = local_24;
let _e4160 = local_25;
let _e4164 = local_26;
let _e4168 = local_27;
let _e4172 = local_28;
let _e4176 = local_29;
let _e4180 = local_30;
let _e4185 = local_31;
let _e4188 = local_32;
let _e4191 = local_33;
let _e4194 = local_34;
let _e4197 = local_35;
let _e4201 = local_36;
let _e4205 = local_37;
let _e4209 = local_38;
let _e4213 = local_39;
let _e4217 = local_40;
let _e4221 = local_41;
let _e4225 = local_42;
let _e4229 = local_43;
let _e4233 = local_44;
global_5.member[_e128] = _e4136.member.x;
global_5.member[_e140] = _e4140.member.y;
global_5.member[_e151] = _e4144.member.z;
global_5.member[_e162] = _e4148.member_1.x;
global_5.member[_e173] = _e4152.member_1.y;
global_5.member[_e184] = _e4156.member_1.z;
global_5.member[_e195] = _e4160.member_2.x;
global_5.member[_e206] = _e4164.member_2.y;
global_5.member[_e217] = _e4168.member_2.z;
global_5.member[_e228] = _e4172.member_3.x;
global_5.member[_e239] = _e4176.member_3.y;
global_5.member[_e250] = _e4180.member_3.z;
global_5.member[_e261] = f32(_e4122.member);
global_5.member[_e272] = f32(_e4126.member_1);
global_5.member[_e283] = _e4130.member_2;
global_5.member[_e294] = _e4133.member_3;
let _e4270 = local_45;
global_5.member[_e305] = _e4270;
global_5.member[_e316] = f32(_e4120);
global_5.member[_e327] = _e4185.member_8;
global_5.member[_e338] = _e4188.member_9;
global_5.member[_e349] = _e4191.member_10;
global_5.member[_e360] = _e4194.member_11;
global_5.member[_e371] = _e4197.member_12.x;
global_5.member[_e382] = _e4201.member_12.y;
global_5.member[_e393] = _e4205.member_12.z;
global_5.member[_e404] = _e4209.member_13.x;
global_5.member[_e415] = _e4213.member_13.y;
global_5.member[_e426] = _e4217.member_13.z;
global_5.member[_e437] = f32(_e4221.member_14);
global_5.member[_e448] = f32(_e4225.member_15);
global_5.member[_e459] = f32(_e4229.member_16);
global_5.member[_e470] = _e4233.member_17;
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
