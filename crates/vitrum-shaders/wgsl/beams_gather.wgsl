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
struct type_13 {
member: array<f32>,
}
struct type_17 {
member: u32,
member_1: u32,
}
struct type_18 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
member_12: u32,
member_13: u32,
}
struct type_20 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_21 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_22 {
member: type_2,
member_1: type_17,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_18,
member_12: type_19,
member_13: type_20,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_21,
}
struct type_23 {
member: type_22,
}
struct type_24 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_23;
@group(0) @binding(1)
var<storage> global_2: type_13;
@group(0) @binding(2)
var<storage> global_3: type_13;
@group(0) @binding(3)
var<storage> global_4: type_13;
@group(0) @binding(4)
var<storage> global_5: type_13;
@group(0) @binding(5)
var<storage, read_write> global_6: type_13;
fn function_() {
var local: f32;
var local_1: i32;
var local_2: f32;
var local_3: i32;
var local_4: f32;
var local_5: i32;
var local_6: f32;
var local_7: i32;
var local_8: f32;
var local_9: i32;
var local_10: i32;
var local_11: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var local_15: i32;
var local_16: u32;
var local_17: u32;
var local_18: u32;
var local_19: u32;
var local_20: u32;
var local_21: type_17;
var local_22: u32;
var local_23: type_24;
var local_24: i32;
var local_25: i32;
var phi_1887_: vec3<f32>;
var phi_1890_: vec3<f32>;
var phi_1892_: u32;
var phi_1912_: u32;
var phi_1913_: u32;
var phi_1925_: u32;
var phi_1926_: u32;
var local_26: u32;
var local_27: u32;
var phi_1943_: u32;
var phi_1944_: u32;
var phi_1956_: u32;
var phi_1957_: u32;
var local_28: u32;
var local_29: u32;
var local_30: u32;
var phi_1982_: u32;
var phi_1983_: u32;
var local_31: u32;
var local_32: u32;
var phi_2000_: u32;
var phi_2001_: u32;
var local_33: u32;
var local_34: u32;
var phi_2023_: u32;
var phi_2024_: u32;
var phi_2036_: u32;
var phi_2037_: u32;
var local_35: u32;
var local_36: u32;
var local_37: u32;
var phi_2073_: u32;
var local_38: u32;
var phi_2087_: vec3<f32>;
var phi_2090_: vec3<f32>;
var phi_2092_: type_17;
var phi_2903_: bool;
var phi_2913_: u32;
var phi_2937_: u32;
var phi_2940_: u32;
var phi_2959_: u32;
var phi_3005_: i32;
var phi_2938_: u32;
var phi_2941_: u32;
var phi_3249_: u32;
var phi_3251_: vec3<f32>;
var phi_3254_: vec3<f32>;
var phi_3256_: u32;
var phi_3285_: u32;
var phi_3331_: i32;
var phi_4181_: u32;
var phi_4184_: f32;
var phi_4319_: i32;
var phi_4332_: i32;
var phi_4346_: i32;
var phi_4662_: i32;
var phi_4675_: i32;
var phi_4689_: i32;
var phi_4182_: u32;
var phi_4185_: f32;
var phi_4894_: f32;
var phi_4907_: u32;
var phi_4910_: f32;
var phi_5045_: i32;
var phi_5058_: i32;
var phi_5072_: i32;
var phi_5388_: i32;
var phi_5401_: i32;
var phi_5415_: i32;
var phi_4908_: u32;
var phi_4911_: f32;
var phi_5620_: f32;
var phi_5742_: i32;
var phi_5755_: i32;
var phi_5769_: i32;
var phi_5969_: f32;
var phi_6312_: f32;
var phi_6430_: vec3<f32>;
var phi_6432_: vec3<f32>;
var phi_6433_: bool;
var phi_6476_: vec3<f32>;
var phi_6477_: vec3<f32>;
var phi_3252_: vec3<f32>;
var phi_3255_: vec3<f32>;
var phi_3257_: u32;
var phi_6487_: type_17;
var phi_6488_: type_17;
var phi_6509_: vec3<f32>;
var phi_6510_: vec3<f32>;
var phi_6511_: type_17;
var phi_2088_: vec3<f32>;
var phi_2091_: vec3<f32>;
var phi_2093_: type_17;
var phi_1888_: vec3<f32>;
var phi_1891_: vec3<f32>;
var phi_1893_: u32;
var local_39: vec3<f32>;
var local_40: vec3<f32>;
var local_41: vec3<f32>;
var local_42: vec3<f32>;
var local_43: vec3<f32>;
var local_44: vec3<f32>;
var phi_6562_: array<f32, 19>;
var local_45: u32;
var local_46: f32;
var local_47: f32;
var local_48: vec3<f32>;
var local_49: vec3<f32>;
var local_50: type_17;
var local_51: vec3<f32>;
var local_52: vec3<f32>;
let _e130 = global;
let _e136 = arrayLength((&global_3.member));
let _e142 = arrayLength((&global_5.member));
let _e147 = global_1.member.member;
if (_e130.x < _e147.member) {
if (_e130.y < _e147.member_1) {
let _e154 = (_e147.member * _e147.member_1);
let _e156 = ((_e130.y * _e147.member) + _e130.x);
let _e157 = bitcast<i32>(_e156);
let _e159 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e161 = select(_e159, _e157, (_e157 < _e159));
let _e167 = global_6.member[bitcast<u32>(select(0i, _e161, (_e161 > 0i)))];
let _e168 = (_e154 + _e156);
let _e169 = bitcast<i32>(_e168);
let _e171 = select(_e159, _e169, (_e169 < _e159));
let _e177 = global_6.member[bitcast<u32>(select(0i, _e171, (_e171 > 0i)))];
let _e179 = ((2u * _e154) + _e156);
let _e180 = bitcast<i32>(_e179);
let _e182 = select(_e159, _e180, (_e180 < _e159));
let _e188 = global_6.member[bitcast<u32>(select(0i, _e182, (_e182 > 0i)))];
let _e190 = ((3u * _e154) + _e156);
let _e191 = bitcast<i32>(_e190);
let _e193 = select(_e159, _e191, (_e191 < _e159));
let _e199 = global_6.member[bitcast<u32>(select(0i, _e193, (_e193 > 0i)))];
let _e201 = ((4u * _e154) + _e156);
let _e202 = bitcast<i32>(_e201);
let _e204 = select(_e159, _e202, (_e202 < _e159));
let _e210 = global_6.member[bitcast<u32>(select(0i, _e204, (_e204 > 0i)))];
let _e212 = ((5u * _e154) + _e156);
let _e213 = bitcast<i32>(_e212);
let _e215 = select(_e159, _e213, (_e213 < _e159));
let _e221 = global_6.member[bitcast<u32>(select(0i, _e215, (_e215 > 0i)))];
let _e223 = ((6u * _e154) + _e156);
let _e224 = bitcast<i32>(_e223);
let _e226 = select(_e159, _e224, (_e224 < _e159));
let _e232 = global_6.member[bitcast<u32>(select(0i, _e226, (_e226 > 0i)))];
let _e234 = ((7u * _e154) + _e156);
let _e235 = bitcast<i32>(_e234);
let _e237 = select(_e159, _e235, (_e235 < _e159));
let _e243 = global_6.member[bitcast<u32>(select(0i, _e237, (_e237 > 0i)))];
let _e245 = ((8u * _e154) + _e156);
let _e246 = bitcast<i32>(_e245);
let _e248 = select(_e159, _e246, (_e246 < _e159));
let _e254 = global_6.member[bitcast<u32>(select(0i, _e248, (_e248 > 0i)))];
let _e256 = ((9u * _e154) + _e156);
let _e257 = bitcast<i32>(_e256);
let _e259 = select(_e159, _e257, (_e257 < _e159));
let _e265 = global_6.member[bitcast<u32>(select(0i, _e259, (_e259 > 0i)))];
let _e267 = ((10u * _e154) + _e156);
let _e268 = bitcast<i32>(_e267);
let _e270 = select(_e159, _e268, (_e268 < _e159));
let _e276 = global_6.member[bitcast<u32>(select(0i, _e270, (_e270 > 0i)))];
let _e278 = ((11u * _e154) + _e156);
let _e279 = bitcast<i32>(_e278);
let _e281 = select(_e159, _e279, (_e279 < _e159));
let _e287 = global_6.member[bitcast<u32>(select(0i, _e281, (_e281 > 0i)))];
let _e289 = ((12u * _e154) + _e156);
let _e290 = bitcast<i32>(_e289);
let _e292 = select(_e159, _e290, (_e290 < _e159));
let _e298 = global_6.member[bitcast<u32>(select(0i, _e292, (_e292 > 0i)))];
let _e300 = ((13u * _e154) + _e156);
let _e301 = bitcast<i32>(_e300);
let _e303 = select(_e159, _e301, (_e301 < _e159));
let _e309 = global_6.member[bitcast<u32>(select(0i, _e303, (_e303 > 0i)))];
let _e311 = ((14u * _e154) + _e156);
let _e312 = bitcast<i32>(_e311);
let _e314 = select(_e159, _e312, (_e312 < _e159));
let _e320 = global_6.member[bitcast<u32>(select(0i, _e314, (_e314 > 0i)))];
let _e322 = ((15u * _e154) + _e156);
let _e323 = bitcast<i32>(_e322);
let _e325 = select(_e159, _e323, (_e323 < _e159));
let _e331 = global_6.member[bitcast<u32>(select(0i, _e325, (_e325 > 0i)))];
let _e333 = ((16u * _e154) + _e156);
let _e334 = bitcast<i32>(_e333);
let _e336 = select(_e159, _e334, (_e334 < _e159));
let _e342 = global_6.member[bitcast<u32>(select(0i, _e336, (_e336 > 0i)))];
let _e344 = ((17u * _e154) + _e156);
let _e345 = bitcast<i32>(_e344);
let _e347 = select(_e159, _e345, (_e345 < _e159));
let _e353 = global_6.member[bitcast<u32>(select(0i, _e347, (_e347 > 0i)))];
let _e355 = ((18u * _e154) + _e156);
let _e356 = bitcast<i32>(_e355);
let _e358 = select(_e159, _e356, (_e356 < _e159));
let _e364 = global_6.member[bitcast<u32>(select(0i, _e358, (_e358 > 0i)))];
let _e369 = global_1.member.member.member;
let _e373 = global_1.member.member.member_1;
let _e374 = (_e369 * _e373);
local_24 = bitcast<i32>(_e374);
let _e377 = ((_e130.y * _e369) + _e130.x);
let _e378 = bitcast<i32>(_e377);
local_25 = _e378;
let _e379 = local_24;
let _e381 = local_25;
let _e382 = ((29i * _e379) + _e381);
let _e384 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e386 = select(_e384, _e382, (_e382 < _e384));
let _e391 = global_2.member[bitcast<u32>(select(0i, _e386, (_e386 > 0i)))];
let _e393 = local_24;
let _e395 = local_25;
let _e396 = ((36i * _e393) + _e395);
let _e398 = select(_e384, _e396, (_e396 < _e384));
let _e403 = global_2.member[bitcast<u32>(select(0i, _e398, (_e398 > 0i)))];
let _e414 = global_1.member.member_12.member_4;
if (select(0u, 3u, ((_e391 == 2f) && (select(0i, select(select(i32(_e403), i32(-2147483648), (_e403 < -2147483600f)), 2147483647i, (_e403 > 2147483500f)), (_e403 == _e403)) == (bitcast<i32>(_e414) + 1i)))) > 1u) {
let _e422 = select(_e384, _e378, (_e378 < _e384));
let _e428 = global_2.member[bitcast<u32>(select(0i, _e422, (_e422 > 0i)))];
let _e430 = bitcast<i32>((_e374 + _e377));
let _e432 = select(_e384, _e430, (_e430 < _e384));
let _e438 = global_2.member[bitcast<u32>(select(0i, _e432, (_e432 > 0i)))];
let _e441 = bitcast<i32>(((2u * _e374) + _e377));
let _e443 = select(_e384, _e441, (_e441 < _e384));
let _e449 = global_2.member[bitcast<u32>(select(0i, _e443, (_e443 > 0i)))];
let _e452 = bitcast<i32>(((3u * _e374) + _e377));
let _e454 = select(_e384, _e452, (_e452 < _e384));
let _e460 = global_2.member[bitcast<u32>(select(0i, _e454, (_e454 > 0i)))];
let _e463 = bitcast<i32>(((4u * _e374) + _e377));
let _e465 = select(_e384, _e463, (_e463 < _e384));
let _e471 = global_2.member[bitcast<u32>(select(0i, _e465, (_e465 > 0i)))];
let _e474 = bitcast<i32>(((5u * _e374) + _e377));
let _e476 = select(_e384, _e474, (_e474 < _e384));
let _e482 = global_2.member[bitcast<u32>(select(0i, _e476, (_e476 > 0i)))];
let _e485 = bitcast<i32>(((6u * _e374) + _e377));
let _e487 = select(_e384, _e485, (_e485 < _e384));
let _e493 = global_2.member[bitcast<u32>(select(0i, _e487, (_e487 > 0i)))];
let _e496 = bitcast<i32>(((7u * _e374) + _e377));
let _e498 = select(_e384, _e496, (_e496 < _e384));
let _e504 = global_2.member[bitcast<u32>(select(0i, _e498, (_e498 > 0i)))];
let _e507 = bitcast<i32>(((8u * _e374) + _e377));
let _e509 = select(_e384, _e507, (_e507 < _e384));
let _e515 = global_2.member[bitcast<u32>(select(0i, _e509, (_e509 > 0i)))];
let _e518 = bitcast<i32>(((9u * _e374) + _e377));
let _e520 = select(_e384, _e518, (_e518 < _e384));
let _e526 = global_2.member[bitcast<u32>(select(0i, _e520, (_e520 > 0i)))];
let _e529 = bitcast<i32>(((10u * _e374) + _e377));
let _e531 = select(_e384, _e529, (_e529 < _e384));
let _e537 = global_2.member[bitcast<u32>(select(0i, _e531, (_e531 > 0i)))];
let _e540 = bitcast<i32>(((11u * _e374) + _e377));
let _e542 = select(_e384, _e540, (_e540 < _e384));
let _e548 = global_2.member[bitcast<u32>(select(0i, _e542, (_e542 > 0i)))];
let _e551 = bitcast<i32>(((12u * _e374) + _e377));
let _e553 = select(_e384, _e551, (_e551 < _e384));
let _e559 = global_2.member[bitcast<u32>(select(0i, _e553, (_e553 > 0i)))];
let _e562 = bitcast<i32>(((13u * _e374) + _e377));
let _e564 = select(_e384, _e562, (_e562 < _e384));
let _e570 = global_2.member[bitcast<u32>(select(0i, _e564, (_e564 > 0i)))];
let _e573 = bitcast<i32>(((14u * _e374) + _e377));
let _e575 = select(_e384, _e573, (_e573 < _e384));
let _e581 = global_2.member[bitcast<u32>(select(0i, _e575, (_e575 > 0i)))];
let _e584 = bitcast<i32>(((15u * _e374) + _e377));
let _e586 = select(_e384, _e584, (_e584 < _e384));
let _e592 = global_2.member[bitcast<u32>(select(0i, _e586, (_e586 > 0i)))];
let _e595 = bitcast<i32>(((16u * _e374) + _e377));
let _e597 = select(_e384, _e595, (_e595 < _e384));
let _e603 = global_2.member[bitcast<u32>(select(0i, _e597, (_e597 > 0i)))];
let _e606 = bitcast<i32>(((17u * _e374) + _e377));
let _e608 = select(_e384, _e606, (_e606 < _e384));
let _e614 = global_2.member[bitcast<u32>(select(0i, _e608, (_e608 > 0i)))];
let _e617 = bitcast<i32>(((18u * _e374) + _e377));
let _e619 = select(_e384, _e617, (_e617 < _e384));
let _e625 = global_2.member[bitcast<u32>(select(0i, _e619, (_e619 > 0i)))];
let _e628 = bitcast<i32>(((19u * _e374) + _e377));
let _e630 = select(_e384, _e628, (_e628 < _e384));
let _e636 = global_2.member[bitcast<u32>(select(0i, _e630, (_e630 > 0i)))];
let _e639 = bitcast<i32>(((20u * _e374) + _e377));
let _e641 = select(_e384, _e639, (_e639 < _e384));
let _e647 = global_2.member[bitcast<u32>(select(0i, _e641, (_e641 > 0i)))];
let _e650 = bitcast<i32>(((24u * _e374) + _e377));
let _e652 = select(_e384, _e650, (_e650 < _e384));
let _e658 = global_2.member[bitcast<u32>(select(0i, _e652, (_e652 > 0i)))];
let _e661 = bitcast<i32>(((30u * _e374) + _e377));
let _e663 = select(_e384, _e661, (_e661 < _e384));
let _e669 = global_2.member[bitcast<u32>(select(0i, _e663, (_e663 > 0i)))];
let _e677 = (select(0i, select(select(i32(_e669), i32(-2147483648), (_e669 < -2147483600f)), 2147483647i, (_e669 > 2147483500f)), (_e669 == _e669)) == 0i);
let _e685 = global_1.member.member_1.member;
let _e691 = global_1.member.member_1.member_1;
let _e701 = global_1.member.member_2.member;
let _e702 = (((((f32(bitcast<i32>(_e130.x)) + 0.5f) / f32(bitcast<i32>(_e685))) * 2f) - 1f) * _e701);
let _e710 = global_1.member.member_2.member_1;
let _e711 = ((1f - (((f32(bitcast<i32>(_e130.y)) + 0.5f) / f32(bitcast<i32>(_e691))) * 2f)) * _e710);
let _e714 = global_1.member.member_3;
let _e723 = global_1.member.member_4;
let _e736 = global_1.member.member_2.member_3;
let _e737 = (_e736 != 0u);
let _e740 = global_1.member.member_6;
let _e747 = select(_e740.member, (_e740.member + ((_e714.member * _e702) + (_e723.member * _e711))), _e737);
let _e748 = select(_e740.member_1, (_e740.member_1 + ((_e714.member_1 * _e702) + (_e723.member_1 * _e711))), _e737);
let _e749 = select(_e740.member_2, (_e740.member_2 + ((_e714.member_2 * _e702) + (_e723.member_2 * _e711))), _e737);
let _e759 = select(_e428, _e747, _e677);
let _e760 = select(_e438, _e748, _e677);
let _e761 = select(_e449, _e749, _e677);
let _e762 = (select(0f, ((((_e428 - _e747) * _e460) + ((_e438 - _e748) * _e471)) + ((_e449 - _e749) * _e482)), _e677) + _e658);
let _e763 = select(_e625, 1f, _e677);
let _e764 = select(_e636, 1f, _e677);
let _e765 = select(_e647, 1f, _e677);
let _e773 = (1f / select(_e460, select(1e-12f, -1e-12f, (_e460 < 0f)), (bitcast<f32>((bitcast<u32>(_e460) & 2147483647u)) < 1e-12f)));
let _e781 = (1f / select(_e471, select(1e-12f, -1e-12f, (_e471 < 0f)), (bitcast<f32>((bitcast<u32>(_e471) & 2147483647u)) < 1e-12f)));
let _e789 = (1f / select(_e482, select(1e-12f, -1e-12f, (_e482 < 0f)), (bitcast<f32>((bitcast<u32>(_e482) & 2147483647u)) < 1e-12f)));
let _e793 = global_1.member.member_13.member_4;
let _e800 = global_1.member.member_13.member_5;
let _e805 = ((_e793.member - _e759) * _e773);
let _e807 = ((_e800.member - _e759) * _e773);
let _e809 = ((_e793.member_1 - _e760) * _e781);
let _e811 = ((_e800.member_1 - _e760) * _e781);
let _e813 = ((_e793.member_2 - _e761) * _e789);
let _e815 = ((_e800.member_2 - _e761) * _e789);
let _e817 = select(_e807, _e805, (_e805 < _e807));
let _e819 = select(_e811, _e809, (_e809 < _e811));
let _e821 = select(_e819, _e817, (_e817 > _e819));
let _e823 = select(_e815, _e813, (_e813 < _e815));
let _e825 = select(_e823, _e821, (_e821 > _e823));
let _e827 = select(_e807, _e805, (_e805 > _e807));
let _e829 = select(_e811, _e809, (_e809 > _e811));
let _e831 = select(_e829, _e827, (_e827 < _e829));
let _e833 = select(_e815, _e813, (_e813 > _e815));
let _e835 = select(_e833, _e831, (_e831 < _e833));
let _e837 = select(0f, _e825, (_e825 > 0f));
let _e839 = select(_e762, _e835, (_e835 < _e762));
let _e840 = (_e839 > _e837);
let _e841 = select(0f, _e837, _e840);
let _e842 = select(0f, _e839, _e840);
if ((_e677 || (_e842 <= _e841)) || ((((_e763 + _e764) + _e765) * (1f / 3f)) < 0.01f)) {
phi_6562_ = array<f32, 19>(_e167, _e177, _e188, _e199, _e210, _e221, _e232, _e243, _e254, _e265, _e276, _e287, _e298, _e309, _e320, _e331, _e342, _e353, _e364);
} else {
let _e855 = (((_e493 * _e493) + (_e504 * _e504)) + (_e515 * _e515));
let _e863 = (((_e526 * _e526) + (_e537 * _e537)) + (_e548 * _e548));
let _e868 = (0.5f * (sqrt(select(0f, _e855, (_e855 > 0f))) + sqrt(select(0f, _e863, (_e863 > 0f)))));
let _e873 = (((_e559 * _e559) + (_e570 * _e570)) + (_e581 * _e581));
let _e881 = (((_e592 * _e592) + (_e603 * _e603)) + (_e614 * _e614));
let _e886 = (0.5f * (sqrt(select(0f, _e873, (_e873 > 0f))) + sqrt(select(0f, _e881, (_e881 > 0f)))));
let _e890 = global_1.member.member_11.member;
let _e892 = bitcast<i32>((_e890 * _e890));
phi_1887_ = vec3<f32>(0f, 0f, 0f);
phi_1890_ = vec3<f32>(0f, 0f, 0f);
phi_1892_ = 0u;
loop {
let _e894 = phi_1887_;
let _e896 = phi_1890_;
let _e898 = phi_1892_;
local_39 = _e896;
local_40 = _e896;
local_41 = _e896;
local_42 = _e894;
local_43 = _e894;
local_44 = _e894;
let _e902 = global_1.member.member_12.member_9;
let _e903 = (_e898 <= _e902);
if _e903 {
let _e907 = global_1.member.member_12.member_6;
let _e909 = bitcast<i32>((_e898 * _e907));
phi_1912_ = 0u;
loop {
let _e911 = phi_1912_;
local_38 = _e911;
let _e915 = ((1u << bitcast<u32>((_e911 & 31u))) < _e890);
if _e915 {
phi_1913_ = (_e911 + 1u);
} else {
phi_1913_ = u32();
}
let _e918 = phi_1913_;
continue;
continuing {
phi_1912_ = _e918;
break if !(_e915);
}
}
phi_1925_ = 0u;
loop {
let _e921 = phi_1925_;
local_26 = _e921;
local_27 = _e921;
let _e925 = ((1u << bitcast<u32>((_e921 & 31u))) < _e890);
if _e925 {
phi_1926_ = (_e921 + 1u);
} else {
phi_1926_ = u32();
}
let _e928 = phi_1926_;
continue;
continuing {
phi_1925_ = _e928;
break if !(_e925);
}
}
let _e931 = local_26;
let _e934 = local_27;
phi_1943_ = 0u;
loop {
let _e937 = phi_1943_;
local_30 = _e937;
let _e941 = ((1u << bitcast<u32>((_e937 & 31u))) < _e890);
if _e941 {
phi_1944_ = (_e937 + 1u);
} else {
phi_1944_ = u32();
}
let _e944 = phi_1944_;
continue;
continuing {
phi_1943_ = _e944;
break if !(_e941);
}
}
phi_1956_ = 0u;
loop {
let _e947 = phi_1956_;
local_28 = _e947;
local_29 = _e947;
let _e951 = ((1u << bitcast<u32>((_e947 & 31u))) < _e890);
if _e951 {
phi_1957_ = (_e947 + 1u);
} else {
phi_1957_ = u32();
}
let _e954 = phi_1957_;
continue;
continuing {
phi_1956_ = _e954;
break if !(_e951);
}
}
let _e957 = local_28;
let _e960 = local_29;
let _e963 = local_30;
let _e972 = global_1.member.member_12.member_8;
phi_1982_ = 0u;
loop {
let _e975 = phi_1982_;
local_31 = _e975;
local_32 = _e975;
let _e979 = ((1u << bitcast<u32>((_e975 & 31u))) < _e890);
if _e979 {
phi_1983_ = (_e975 + 1u);
} else {
phi_1983_ = u32();
}
let _e982 = phi_1983_;
continue;
continuing {
phi_1982_ = _e982;
break if !(_e979);
}
}
let _e985 = local_31;
let _e988 = local_32;
phi_2000_ = 0u;
loop {
let _e991 = phi_2000_;
local_33 = _e991;
local_34 = _e991;
let _e995 = ((1u << bitcast<u32>((_e991 & 31u))) < _e890);
if _e995 {
phi_2001_ = (_e991 + 1u);
} else {
phi_2001_ = u32();
}
let _e998 = phi_2001_;
continue;
continuing {
phi_2000_ = _e998;
break if !(_e995);
}
}
let _e1001 = local_33;
let _e1007 = local_34;
phi_2023_ = 0u;
loop {
let _e1017 = phi_2023_;
local_37 = _e1017;
let _e1021 = ((1u << bitcast<u32>((_e1017 & 31u))) < _e890);
if _e1021 {
phi_2024_ = (_e1017 + 1u);
} else {
phi_2024_ = u32();
}
let _e1024 = phi_2024_;
continue;
continuing {
phi_2023_ = _e1024;
break if !(_e1021);
}
}
phi_2036_ = 0u;
loop {
let _e1027 = phi_2036_;
local_35 = _e1027;
local_36 = _e1027;
let _e1031 = ((1u << bitcast<u32>((_e1027 & 31u))) < _e890);
if _e1031 {
phi_2037_ = (_e1027 + 1u);
} else {
phi_2037_ = u32();
}
let _e1034 = phi_2037_;
continue;
continuing {
phi_2036_ = _e1034;
break if !(_e1031);
}
}
let _e1037 = local_35;
let _e1040 = local_36;
let _e1043 = local_37;
let _e1049 = (((((1u << bitcast<u32>(((2u * _e1001) & 31u))) - (1u << bitcast<u32>(((2u * (_e1007 - select(6u, _e988, (_e985 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e1043 - select(6u, _e1040, (_e1037 < 6u)))) & 31u))));
let _e1050 = (_e1049 / 64u);
if ((_e1049 % 64u) > 0u) {
phi_2073_ = (_e1050 + 1u);
} else {
phi_2073_ = _e1050;
}
let _e1055 = phi_2073_;
let _e1058 = local_38;
local_23 = type_24(_e1058, select(6u, _e934, (_e931 < 6u)), (1u << bitcast<u32>(((2u * (_e963 - select(6u, _e960, (_e957 < 6u)))) & 31u))), (_e898 * _e972), (_e1055 * 64u));
let _e1060 = (_e898 == 0u);
let _e1062 = local_23.member_1;
phi_2087_ = _e894;
phi_2090_ = _e896;
phi_2092_ = type_17(_e1062, 0u);
loop {
let _e1065 = phi_2087_;
let _e1067 = phi_2090_;
let _e1069 = phi_2092_;
local_51 = _e1065;
local_52 = _e1067;
let _e1072 = local_23.member_1;
let _e1075 = local_23.member_2;
let _e1077 = ((_e1069.member < _e1072) || (_e1069.member_1 < _e1075));
if _e1077 {
local_21.member = _e1069.member;
local_21.member_1 = _e1069.member_1;
let _e1080 = local_21.member;
let _e1081 = local_21.member_1;
let _e1083 = local_23.member;
let _e1098 = local_23.member_3;
local_22 = (_e1098 + (((((1u << bitcast<u32>(((2u * _e1083) & 31u))) - (1u << bitcast<u32>(((2u * (_e1083 - _e1080)) & 31u)))) / 3u) * 4u) + _e1081));
let _e1100 = local_22;
let _e1101 = bitcast<i32>(_e1100);
let _e1103 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e1105 = select(_e1103, _e1101, (_e1101 < _e1103));
let _e1110 = global_4.member[bitcast<u32>(select(0i, _e1105, (_e1105 > 0i)))];
let _e1111 = local_22;
let _e1113 = local_23.member_4;
let _e1115 = bitcast<i32>((_e1111 + _e1113));
let _e1117 = select(_e1103, _e1115, (_e1115 < _e1103));
let _e1122 = global_4.member[bitcast<u32>(select(0i, _e1117, (_e1117 > 0i)))];
let _e1123 = local_22;
let _e1124 = local_23.member_4;
let _e1127 = bitcast<i32>((_e1123 + (2u * _e1124)));
let _e1129 = select(_e1103, _e1127, (_e1127 < _e1103));
let _e1134 = global_4.member[bitcast<u32>(select(0i, _e1129, (_e1129 > 0i)))];
let _e1135 = local_21.member;
let _e1136 = local_21.member_1;
let _e1137 = local_23.member;
let _e1151 = local_23.member_3;
let _e1152 = local_23.member_4;
local_20 = ((_e1151 + (3u * _e1152)) + (((((1u << bitcast<u32>(((2u * _e1137) & 31u))) - (1u << bitcast<u32>(((2u * (_e1137 - _e1135)) & 31u)))) / 3u) * 4u) + _e1136));
let _e1156 = local_20;
let _e1157 = bitcast<i32>(_e1156);
let _e1159 = select(_e1103, _e1157, (_e1157 < _e1103));
let _e1164 = global_4.member[bitcast<u32>(select(0i, _e1159, (_e1159 > 0i)))];
let _e1165 = local_20;
let _e1166 = local_23.member_4;
let _e1168 = bitcast<i32>((_e1165 + _e1166));
let _e1170 = select(_e1103, _e1168, (_e1168 < _e1103));
let _e1175 = global_4.member[bitcast<u32>(select(0i, _e1170, (_e1170 > 0i)))];
let _e1176 = local_20;
let _e1177 = local_23.member_4;
let _e1180 = bitcast<i32>((_e1176 + (2u * _e1177)));
let _e1182 = select(_e1103, _e1180, (_e1180 < _e1103));
let _e1187 = global_4.member[bitcast<u32>(select(0i, _e1182, (_e1182 > 0i)))];
let _e1189 = ((_e1110 - _e759) * _e773);
let _e1191 = ((_e1164 - _e759) * _e773);
let _e1193 = ((_e1122 - _e760) * _e781);
let _e1195 = ((_e1175 - _e760) * _e781);
let _e1197 = ((_e1134 - _e761) * _e789);
let _e1199 = ((_e1187 - _e761) * _e789);
let _e1201 = select(_e1191, _e1189, (_e1189 < _e1191));
let _e1203 = select(_e1195, _e1193, (_e1193 < _e1195));
let _e1205 = select(_e1203, _e1201, (_e1201 > _e1203));
let _e1207 = select(_e1199, _e1197, (_e1197 < _e1199));
let _e1209 = select(_e1207, _e1205, (_e1205 > _e1207));
let _e1211 = select(_e1191, _e1189, (_e1189 > _e1191));
let _e1213 = select(_e1195, _e1193, (_e1193 > _e1195));
let _e1215 = select(_e1213, _e1211, (_e1211 < _e1213));
let _e1217 = select(_e1199, _e1197, (_e1197 > _e1199));
let _e1219 = select(_e1217, _e1215, (_e1215 < _e1217));
if ((_e1110 <= _e1164) && (select(_e841, _e1209, (_e1209 > _e841)) <= select(_e842, _e1219, (_e1219 < _e842)))) {
let _e1227 = local_21.member;
let _e1228 = local_21.member_1;
let _e1229 = local_23.member;
let _e1243 = local_23.member_3;
let _e1244 = local_23.member_4;
local_19 = ((_e1243 + (6u * _e1244)) + (((((1u << bitcast<u32>(((2u * _e1229) & 31u))) - (1u << bitcast<u32>(((2u * (_e1229 - _e1227)) & 31u)))) / 3u) * 4u) + _e1228));
let _e1248 = local_19;
let _e1249 = bitcast<i32>(_e1248);
let _e1251 = select(_e1103, _e1249, (_e1249 < _e1103));
let _e1256 = global_4.member[bitcast<u32>(select(0i, _e1251, (_e1251 > 0i)))];
let _e1257 = local_19;
let _e1258 = local_23.member_4;
let _e1260 = bitcast<i32>((_e1257 + _e1258));
let _e1262 = select(_e1103, _e1260, (_e1260 < _e1103));
let _e1267 = global_4.member[bitcast<u32>(select(0i, _e1262, (_e1262 > 0i)))];
let _e1268 = local_19;
let _e1269 = local_23.member_4;
let _e1272 = bitcast<i32>((_e1268 + (2u * _e1269)));
let _e1274 = select(_e1103, _e1272, (_e1272 < _e1103));
let _e1279 = global_4.member[bitcast<u32>(select(0i, _e1274, (_e1274 > 0i)))];
let _e1280 = local_21.member;
let _e1281 = local_21.member_1;
let _e1282 = local_23.member;
let _e1296 = local_23.member_3;
let _e1297 = local_23.member_4;
local_18 = ((_e1296 + (9u * _e1297)) + (((((1u << bitcast<u32>(((2u * _e1282) & 31u))) - (1u << bitcast<u32>(((2u * (_e1282 - _e1280)) & 31u)))) / 3u) * 4u) + _e1281));
let _e1301 = local_18;
let _e1302 = bitcast<i32>(_e1301);
let _e1304 = select(_e1103, _e1302, (_e1302 < _e1103));
let _e1309 = global_4.member[bitcast<u32>(select(0i, _e1304, (_e1304 > 0i)))];
let _e1310 = local_18;
let _e1311 = local_23.member_4;
let _e1313 = bitcast<i32>((_e1310 + _e1311));
let _e1315 = select(_e1103, _e1313, (_e1313 < _e1103));
let _e1320 = global_4.member[bitcast<u32>(select(0i, _e1315, (_e1315 > 0i)))];
let _e1321 = local_18;
let _e1322 = local_23.member_4;
let _e1325 = bitcast<i32>((_e1321 + (2u * _e1322)));
let _e1327 = select(_e1103, _e1325, (_e1325 < _e1103));
let _e1332 = global_4.member[bitcast<u32>(select(0i, _e1327, (_e1327 > 0i)))];
let _e1333 = local_21.member;
let _e1334 = local_21.member_1;
let _e1335 = local_23.member;
let _e1349 = local_23.member_3;
let _e1350 = local_23.member_4;
local_17 = ((_e1349 + (12u * _e1350)) + (((((1u << bitcast<u32>(((2u * _e1335) & 31u))) - (1u << bitcast<u32>(((2u * (_e1335 - _e1333)) & 31u)))) / 3u) * 4u) + _e1334));
let _e1354 = local_17;
let _e1355 = bitcast<i32>(_e1354);
let _e1357 = select(_e1103, _e1355, (_e1355 < _e1103));
let _e1362 = global_4.member[bitcast<u32>(select(0i, _e1357, (_e1357 > 0i)))];
let _e1363 = local_17;
let _e1364 = local_23.member_4;
let _e1366 = bitcast<i32>((_e1363 + _e1364));
let _e1368 = select(_e1103, _e1366, (_e1366 < _e1103));
let _e1373 = global_4.member[bitcast<u32>(select(0i, _e1368, (_e1368 > 0i)))];
let _e1374 = local_17;
let _e1375 = local_23.member_4;
let _e1378 = bitcast<i32>((_e1374 + (2u * _e1375)));
let _e1380 = select(_e1103, _e1378, (_e1378 < _e1103));
let _e1385 = global_4.member[bitcast<u32>(select(0i, _e1380, (_e1380 > 0i)))];
let _e1386 = local_21.member;
let _e1387 = local_21.member_1;
let _e1388 = local_23.member;
let _e1402 = local_23.member_3;
let _e1403 = local_23.member_4;
local_16 = ((_e1402 + (15u * _e1403)) + (((((1u << bitcast<u32>(((2u * _e1388) & 31u))) - (1u << bitcast<u32>(((2u * (_e1388 - _e1386)) & 31u)))) / 3u) * 4u) + _e1387));
let _e1407 = local_16;
let _e1408 = bitcast<i32>(_e1407);
let _e1410 = select(_e1103, _e1408, (_e1408 < _e1103));
let _e1415 = global_4.member[bitcast<u32>(select(0i, _e1410, (_e1410 > 0i)))];
let _e1416 = local_16;
let _e1417 = local_23.member_4;
let _e1419 = bitcast<i32>((_e1416 + _e1417));
let _e1421 = select(_e1103, _e1419, (_e1419 < _e1103));
let _e1426 = global_4.member[bitcast<u32>(select(0i, _e1421, (_e1421 > 0i)))];
let _e1427 = local_16;
let _e1428 = local_23.member_4;
let _e1431 = bitcast<i32>((_e1427 + (2u * _e1428)));
let _e1433 = select(_e1103, _e1431, (_e1431 < _e1103));
let _e1438 = global_4.member[bitcast<u32>(select(0i, _e1433, (_e1433 > 0i)))];
let _e1439 = (_e1256 - _e759);
let _e1440 = (_e1267 - _e760);
let _e1441 = (_e1279 - _e761);
let _e1444 = ((_e1373 * _e482) - (_e1385 * _e471));
let _e1447 = ((_e1385 * _e460) - (_e1362 * _e482));
let _e1450 = ((_e1362 * _e471) - (_e1373 * _e460));
let _e1498 = (((_e1309 * _e1309) + (_e1320 * _e1320)) + (_e1332 * _e1332));
let _e1501 = sqrt(select(0f, _e1498, (_e1498 > 0f)));
let _e1506 = (((_e1415 * _e1415) + (_e1426 * _e1426)) + (_e1438 * _e1438));
let _e1516 = (((_e1439 * _e1439) + (_e1440 * _e1440)) + (_e1441 * _e1441));
phi_2903_ = (bitcast<f32>((bitcast<u32>((((_e1439 * _e1444) + (_e1440 * _e1447)) + (_e1441 * _e1450))) & 2147483647u)) <= ((((((bitcast<f32>((bitcast<u32>(_e1444) & 2147483647u)) * _e1309) + (bitcast<f32>((bitcast<u32>(_e1447) & 2147483647u)) * _e1320)) + (bitcast<f32>((bitcast<u32>(_e1450) & 2147483647u)) * _e1332)) + (((bitcast<f32>((bitcast<u32>(((_e471 * _e1441) - (_e482 * _e1440))) & 2147483647u)) * _e1415) + (bitcast<f32>((bitcast<u32>(((_e482 * _e1439) - (_e460 * _e1441))) & 2147483647u)) * _e1426)) + (bitcast<f32>((bitcast<u32>(((_e460 * _e1440) - (_e471 * _e1439))) & 2147483647u)) * _e1438))) + (_e1501 * sqrt(select(0f, _e1506, (_e1506 > 0f))))) + (_e868 + (_e886 * (sqrt(select(0f, _e1516, (_e1516 > 0f))) + _e1501)))));
} else {
phi_2903_ = false;
}
let _e1529 = phi_2903_;
let _e1530 = local_23.member_1;
if (_e1530 < 2u) {
let _e1532 = local_23.member_1;
phi_2913_ = _e1532;
} else {
phi_2913_ = 2u;
}
let _e1534 = phi_2913_;
if (_e1529 && (_e1069.member > _e1534)) {
phi_6509_ = _e1065;
phi_6510_ = _e1067;
phi_6511_ = type_17((_e1069.member - 1u), (_e1069.member_1 << bitcast<u32>(2i)));
} else {
if _e1529 {
phi_2937_ = 0u;
phi_2940_ = 0u;
loop {
let _e1538 = phi_2937_;
let _e1540 = phi_2940_;
local_45 = _e1540;
let _e1541 = (_e1538 < 16u);
if _e1541 {
let _e1542 = local_23.member_1;
if (_e1542 < 2u) {
let _e1544 = local_23.member_1;
phi_2959_ = _e1544;
} else {
phi_2959_ = 2u;
}
let _e1546 = phi_2959_;
let _e1548 = ((2u * _e1546) & 31u);
let _e1551 = ((_e1069.member_1 << bitcast<u32>(_e1548)) + _e1538);
let _e1552 = (_e1551 & 1431655765u);
let _e1556 = ((_e1552 | (_e1552 >> bitcast<u32>(1i))) & 858993459u);
let _e1560 = ((_e1556 | (_e1556 >> bitcast<u32>(2i))) & 252645135u);
let _e1564 = ((_e1560 | (_e1560 >> bitcast<u32>(4i))) & 16711935u);
let _e1568 = ((_e1564 | (_e1564 >> bitcast<u32>(8i))) & 65535u);
let _e1571 = ((_e1551 >> bitcast<u32>(1i)) & 1431655765u);
let _e1575 = ((_e1571 | (_e1571 >> bitcast<u32>(1i))) & 858993459u);
let _e1579 = ((_e1575 | (_e1575 >> bitcast<u32>(2i))) & 252645135u);
let _e1583 = ((_e1579 | (_e1579 >> bitcast<u32>(4i))) & 16711935u);
let _e1587 = ((_e1583 | (_e1583 >> bitcast<u32>(8i))) & 65535u);
let _e1594 = (((_e1538 < (1u << bitcast<u32>(_e1548))) && (_e1568 < _e890)) && (_e1587 < _e890));
if _e1594 {
phi_3005_ = bitcast<i32>(((_e1587 * _e890) + _e1568));
} else {
phi_3005_ = 0i;
}
let _e1599 = phi_3005_;
local_13 = _e909;
local_14 = _e1599;
local_15 = _e892;
let _e1600 = local_13;
let _e1601 = local_14;
let _e1602 = (_e1600 + _e1601);
let _e1604 = (bitcast<i32>(_e136) - 1i);
let _e1606 = select(_e1604, _e1602, (_e1602 < _e1604));
let _e1611 = global_3.member[bitcast<u32>(select(0i, _e1606, (_e1606 > 0i)))];
let _e1612 = local_13;
let _e1613 = local_15;
let _e1615 = local_14;
let _e1616 = ((_e1612 + _e1613) + _e1615);
let _e1618 = select(_e1604, _e1616, (_e1616 < _e1604));
let _e1623 = global_3.member[bitcast<u32>(select(0i, _e1618, (_e1618 > 0i)))];
let _e1624 = local_13;
let _e1625 = local_15;
let _e1628 = local_14;
let _e1629 = ((_e1624 + (2i * _e1625)) + _e1628);
let _e1631 = select(_e1604, _e1629, (_e1629 < _e1604));
let _e1636 = global_3.member[bitcast<u32>(select(0i, _e1631, (_e1631 > 0i)))];
let _e1637 = local_13;
let _e1638 = local_15;
let _e1641 = local_14;
let _e1642 = ((_e1637 + (3i * _e1638)) + _e1641);
let _e1644 = select(_e1604, _e1642, (_e1642 < _e1604));
let _e1649 = global_3.member[bitcast<u32>(select(0i, _e1644, (_e1644 > 0i)))];
let _e1650 = local_13;
let _e1651 = local_15;
let _e1654 = local_14;
let _e1655 = ((_e1650 + (4i * _e1651)) + _e1654);
let _e1657 = select(_e1604, _e1655, (_e1655 < _e1604));
let _e1662 = global_3.member[bitcast<u32>(select(0i, _e1657, (_e1657 > 0i)))];
let _e1663 = local_13;
let _e1664 = local_15;
let _e1667 = local_14;
let _e1668 = ((_e1663 + (5i * _e1664)) + _e1667);
let _e1670 = select(_e1604, _e1668, (_e1668 < _e1604));
let _e1675 = global_3.member[bitcast<u32>(select(0i, _e1670, (_e1670 > 0i)))];
let _e1676 = (_e1611 - _e759);
let _e1677 = (_e1623 - _e760);
let _e1678 = (_e1636 - _e761);
let _e1697 = (((_e1676 * _e1676) + (_e1677 * _e1677)) + (_e1678 * _e1678));
let _e1701 = local_13;
let _e1702 = local_15;
let _e1705 = local_14;
let _e1706 = ((_e1701 + (21i * _e1702)) + _e1705);
let _e1708 = select(_e1604, _e1706, (_e1706 < _e1604));
let _e1713 = global_3.member[bitcast<u32>(select(0i, _e1708, (_e1708 > 0i)))];
let _e1718 = local_13;
let _e1719 = local_15;
let _e1722 = local_14;
let _e1723 = ((_e1718 + (22i * _e1719)) + _e1722);
let _e1725 = select(_e1604, _e1723, (_e1723 < _e1604));
let _e1730 = global_3.member[bitcast<u32>(select(0i, _e1725, (_e1725 > 0i)))];
phi_2938_ = (_e1538 + 1u);
phi_2941_ = (_e1540 | (select(0u, 1u, (_e1594 && (bitcast<f32>((bitcast<u32>((((_e460 * ((_e1677 * _e1675) - (_e1678 * _e1662))) + (_e471 * ((_e1678 * _e1649) - (_e1676 * _e1675)))) + (_e482 * ((_e1676 * _e1662) - (_e1677 * _e1649))))) & 2147483647u)) <= ((_e1713 + _e868) + ((_e1730 + _e886) * sqrt(select(0f, _e1697, (_e1697 > 0f)))))))) << bitcast<u32>((_e1538 & 31u))));
} else {
phi_2938_ = u32();
phi_2941_ = u32();
}
let _e1743 = phi_2938_;
let _e1745 = phi_2941_;
continue;
continuing {
phi_2937_ = _e1743;
phi_2940_ = _e1745;
break if !(_e1541);
}
}
let _e4056 = local_45;
phi_3249_ = _e4056;
} else {
phi_3249_ = 0u;
}
let _e1748 = phi_3249_;
phi_3251_ = _e1065;
phi_3254_ = _e1067;
phi_3256_ = 0u;
loop {
let _e1750 = phi_3251_;
let _e1752 = phi_3254_;
let _e1754 = phi_3256_;
local_48 = _e1750;
local_49 = _e1752;
let _e1757 = (_e1748 >> bitcast<u32>((_e1754 & 31u)));
let _e1758 = (_e1757 == 0u);
if _e1758 {
phi_3252_ = vec3<f32>();
phi_3255_ = vec3<f32>();
phi_3257_ = u32();
} else {
if ((_e1757 & 1u) == 0u) {
phi_6476_ = _e1750;
phi_6477_ = _e1752;
} else {
let _e1761 = local_23.member_1;
if (_e1761 < 2u) {
let _e1763 = local_23.member_1;
phi_3285_ = _e1763;
} else {
phi_3285_ = 2u;
}
let _e1765 = phi_3285_;
let _e1767 = ((2u * _e1765) & 31u);
let _e1770 = ((_e1069.member_1 << bitcast<u32>(_e1767)) + _e1754);
let _e1771 = (_e1770 & 1431655765u);
let _e1775 = ((_e1771 | (_e1771 >> bitcast<u32>(1i))) & 858993459u);
let _e1779 = ((_e1775 | (_e1775 >> bitcast<u32>(2i))) & 252645135u);
let _e1783 = ((_e1779 | (_e1779 >> bitcast<u32>(4i))) & 16711935u);
let _e1787 = ((_e1783 | (_e1783 >> bitcast<u32>(8i))) & 65535u);
let _e1790 = ((_e1770 >> bitcast<u32>(1i)) & 1431655765u);
let _e1794 = ((_e1790 | (_e1790 >> bitcast<u32>(1i))) & 858993459u);
let _e1798 = ((_e1794 | (_e1794 >> bitcast<u32>(2i))) & 252645135u);
let _e1802 = ((_e1798 | (_e1798 >> bitcast<u32>(4i))) & 16711935u);
let _e1806 = ((_e1802 | (_e1802 >> bitcast<u32>(8i))) & 65535u);
if (((_e1754 < (1u << bitcast<u32>(_e1767))) && (_e1787 < _e890)) && (_e1806 < _e890)) {
phi_3331_ = bitcast<i32>(((_e1806 * _e890) + _e1787));
} else {
phi_3331_ = 0i;
}
let _e1818 = phi_3331_;
local_10 = _e909;
local_11 = _e1818;
local_12 = _e892;
let _e1819 = local_10;
let _e1820 = local_11;
let _e1821 = (_e1819 + _e1820);
let _e1823 = (bitcast<i32>(_e136) - 1i);
let _e1825 = select(_e1823, _e1821, (_e1821 < _e1823));
let _e1830 = global_3.member[bitcast<u32>(select(0i, _e1825, (_e1825 > 0i)))];
let _e1831 = local_10;
let _e1832 = local_12;
let _e1834 = local_11;
let _e1835 = ((_e1831 + _e1832) + _e1834);
let _e1837 = select(_e1823, _e1835, (_e1835 < _e1823));
let _e1842 = global_3.member[bitcast<u32>(select(0i, _e1837, (_e1837 > 0i)))];
let _e1843 = local_10;
let _e1844 = local_12;
let _e1847 = local_11;
let _e1848 = ((_e1843 + (2i * _e1844)) + _e1847);
let _e1850 = select(_e1823, _e1848, (_e1848 < _e1823));
let _e1855 = global_3.member[bitcast<u32>(select(0i, _e1850, (_e1850 > 0i)))];
let _e1856 = local_10;
let _e1857 = local_12;
let _e1860 = local_11;
let _e1861 = ((_e1856 + (3i * _e1857)) + _e1860);
let _e1863 = select(_e1823, _e1861, (_e1861 < _e1823));
let _e1868 = global_3.member[bitcast<u32>(select(0i, _e1863, (_e1863 > 0i)))];
let _e1869 = local_10;
let _e1870 = local_12;
let _e1873 = local_11;
let _e1874 = ((_e1869 + (4i * _e1870)) + _e1873);
let _e1876 = select(_e1823, _e1874, (_e1874 < _e1823));
let _e1881 = global_3.member[bitcast<u32>(select(0i, _e1876, (_e1876 > 0i)))];
let _e1882 = local_10;
let _e1883 = local_12;
let _e1886 = local_11;
let _e1887 = ((_e1882 + (5i * _e1883)) + _e1886);
let _e1889 = select(_e1823, _e1887, (_e1887 < _e1823));
let _e1894 = global_3.member[bitcast<u32>(select(0i, _e1889, (_e1889 > 0i)))];
let _e1895 = local_10;
let _e1896 = local_12;
let _e1899 = local_11;
let _e1900 = ((_e1895 + (6i * _e1896)) + _e1899);
let _e1902 = select(_e1823, _e1900, (_e1900 < _e1823));
let _e1907 = global_3.member[bitcast<u32>(select(0i, _e1902, (_e1902 > 0i)))];
let _e1908 = local_10;
let _e1909 = local_12;
let _e1912 = local_11;
let _e1913 = ((_e1908 + (7i * _e1909)) + _e1912);
let _e1915 = select(_e1823, _e1913, (_e1913 < _e1823));
let _e1920 = global_3.member[bitcast<u32>(select(0i, _e1915, (_e1915 > 0i)))];
let _e1921 = local_10;
let _e1922 = local_12;
let _e1925 = local_11;
let _e1926 = ((_e1921 + (8i * _e1922)) + _e1925);
let _e1928 = select(_e1823, _e1926, (_e1926 < _e1823));
let _e1933 = global_3.member[bitcast<u32>(select(0i, _e1928, (_e1928 > 0i)))];
let _e1934 = local_10;
let _e1935 = local_12;
let _e1938 = local_11;
let _e1939 = ((_e1934 + (9i * _e1935)) + _e1938);
let _e1941 = select(_e1823, _e1939, (_e1939 < _e1823));
let _e1946 = global_3.member[bitcast<u32>(select(0i, _e1941, (_e1941 > 0i)))];
let _e1947 = local_10;
let _e1948 = local_12;
let _e1951 = local_11;
let _e1952 = ((_e1947 + (10i * _e1948)) + _e1951);
let _e1954 = select(_e1823, _e1952, (_e1952 < _e1823));
let _e1959 = global_3.member[bitcast<u32>(select(0i, _e1954, (_e1954 > 0i)))];
let _e1960 = local_10;
let _e1961 = local_12;
let _e1964 = local_11;
let _e1965 = ((_e1960 + (11i * _e1961)) + _e1964);
let _e1967 = select(_e1823, _e1965, (_e1965 < _e1823));
let _e1972 = global_3.member[bitcast<u32>(select(0i, _e1967, (_e1967 > 0i)))];
let _e1973 = local_10;
let _e1974 = local_12;
let _e1977 = local_11;
let _e1978 = ((_e1973 + (12i * _e1974)) + _e1977);
let _e1980 = select(_e1823, _e1978, (_e1978 < _e1823));
let _e1985 = global_3.member[bitcast<u32>(select(0i, _e1980, (_e1980 > 0i)))];
let _e1986 = local_10;
let _e1987 = local_12;
let _e1990 = local_11;
let _e1991 = ((_e1986 + (13i * _e1987)) + _e1990);
let _e1993 = select(_e1823, _e1991, (_e1991 < _e1823));
let _e1998 = global_3.member[bitcast<u32>(select(0i, _e1993, (_e1993 > 0i)))];
let _e1999 = local_10;
let _e2000 = local_12;
let _e2003 = local_11;
let _e2004 = ((_e1999 + (14i * _e2000)) + _e2003);
let _e2006 = select(_e1823, _e2004, (_e2004 < _e1823));
let _e2011 = global_3.member[bitcast<u32>(select(0i, _e2006, (_e2006 > 0i)))];
let _e2012 = local_10;
let _e2013 = local_12;
let _e2016 = local_11;
let _e2017 = ((_e2012 + (15i * _e2013)) + _e2016);
let _e2019 = select(_e1823, _e2017, (_e2017 < _e1823));
let _e2024 = global_3.member[bitcast<u32>(select(0i, _e2019, (_e2019 > 0i)))];
let _e2025 = local_10;
let _e2026 = local_12;
let _e2029 = local_11;
let _e2030 = ((_e2025 + (16i * _e2026)) + _e2029);
let _e2032 = select(_e1823, _e2030, (_e2030 < _e1823));
let _e2037 = global_3.member[bitcast<u32>(select(0i, _e2032, (_e2032 > 0i)))];
let _e2038 = local_10;
let _e2039 = local_12;
let _e2042 = local_11;
let _e2043 = ((_e2038 + (17i * _e2039)) + _e2042);
let _e2045 = select(_e1823, _e2043, (_e2043 < _e1823));
let _e2050 = global_3.member[bitcast<u32>(select(0i, _e2045, (_e2045 > 0i)))];
let _e2051 = local_10;
let _e2052 = local_12;
let _e2055 = local_11;
let _e2056 = ((_e2051 + (18i * _e2052)) + _e2055);
let _e2058 = select(_e1823, _e2056, (_e2056 < _e1823));
let _e2063 = global_3.member[bitcast<u32>(select(0i, _e2058, (_e2058 > 0i)))];
let _e2064 = local_10;
let _e2065 = local_12;
let _e2068 = local_11;
let _e2069 = ((_e2064 + (19i * _e2065)) + _e2068);
let _e2071 = select(_e1823, _e2069, (_e2069 < _e1823));
let _e2076 = global_3.member[bitcast<u32>(select(0i, _e2071, (_e2071 > 0i)))];
let _e2077 = local_10;
let _e2078 = local_12;
let _e2081 = local_11;
let _e2082 = ((_e2077 + (20i * _e2078)) + _e2081);
let _e2084 = select(_e1823, _e2082, (_e2082 < _e1823));
let _e2089 = global_3.member[bitcast<u32>(select(0i, _e2084, (_e2084 > 0i)))];
let _e2090 = local_10;
let _e2091 = local_12;
let _e2094 = local_11;
let _e2095 = ((_e2090 + (23i * _e2091)) + _e2094);
let _e2097 = select(_e1823, _e2095, (_e2095 < _e1823));
let _e2102 = global_3.member[bitcast<u32>(select(0i, _e2097, (_e2097 > 0i)))];
let _e2103 = (_e1830 - _e759);
let _e2104 = (_e1842 - _e760);
let _e2105 = (_e1855 - _e761);
let _e2108 = ((_e2104 * _e1894) - (_e2105 * _e1881));
let _e2111 = ((_e2105 * _e1868) - (_e2103 * _e1894));
let _e2114 = ((_e2103 * _e1881) - (_e2104 * _e1868));
let _e2119 = (((_e460 * _e2108) + (_e471 * _e2111)) + (_e482 * _e2114));
let _e2148 = bitcast<f32>((bitcast<u32>((((_e460 * (((_e1920 * _e1894) - (_e1933 * _e1881)) + ((_e2104 * _e2011) - (_e2105 * _e1998)))) + (_e471 * (((_e1933 * _e1868) - (_e1907 * _e1894)) + ((_e2105 * _e1985) - (_e2103 * _e2011))))) + (_e482 * (((_e1907 * _e1881) - (_e1920 * _e1868)) + ((_e2103 * _e1998) - (_e2104 * _e1985)))))) & 2147483647u));
let _e2177 = bitcast<f32>((bitcast<u32>((((_e460 * (((_e1959 * _e1894) - (_e1972 * _e1881)) + ((_e2104 * _e2050) - (_e2105 * _e2037)))) + (_e471 * (((_e1972 * _e1868) - (_e1946 * _e1894)) + ((_e2105 * _e2024) - (_e2103 * _e2050))))) + (_e482 * (((_e1946 * _e1881) - (_e1959 * _e1868)) + ((_e2103 * _e2037) - (_e2104 * _e2024)))))) & 2147483647u));
let _e2200 = bitcast<f32>((bitcast<u32>(((((_e559 * _e2108) + (_e570 * _e2111)) + (_e581 * _e2114)) - (((_e460 * ((_e504 * _e1894) - (_e515 * _e1881))) + (_e471 * ((_e515 * _e1868) - (_e493 * _e1894)))) + (_e482 * ((_e493 * _e1881) - (_e504 * _e1868)))))) & 2147483647u));
let _e2223 = bitcast<f32>((bitcast<u32>(((((_e592 * _e2108) + (_e603 * _e2111)) + (_e614 * _e2114)) - (((_e460 * ((_e537 * _e1894) - (_e548 * _e1881))) + (_e471 * ((_e548 * _e1868) - (_e526 * _e1894)))) + (_e482 * ((_e526 * _e1881) - (_e537 * _e1868)))))) & 2147483647u));
let _e2225 = select(_e2223, _e2200, (_e2200 > _e2223));
let _e2227 = select(1e-12f, _e2225, (_e2225 > 1e-12f));
if (bitcast<f32>((bitcast<u32>(_e2119) & 2147483647u)) > (0.5f * ((_e2148 + _e2177) + _e2227))) {
phi_6432_ = vec3<f32>();
phi_6433_ = true;
} else {
let _e2239 = (((_e2103 * _e460) + (_e2104 * _e471)) + (_e2105 * _e482));
let _e2244 = (((_e2103 * _e1868) + (_e2104 * _e1881)) + (_e2105 * _e1894));
let _e2249 = (((_e460 * _e1868) + (_e471 * _e1881)) + (_e482 * _e1894));
let _e2252 = ((_e471 * _e1894) - (_e482 * _e1881));
let _e2255 = ((_e482 * _e1868) - (_e460 * _e1894));
let _e2258 = ((_e460 * _e1881) - (_e471 * _e1868));
let _e2263 = (((_e2252 * _e2252) + (_e2255 * _e2255)) + (_e2258 * _e2258));
let _e2266 = (1f / select(1e-9f, _e2263, (_e2263 > 1e-9f)));
let _e2269 = ((_e2239 - (_e2249 * _e2244)) * _e2266);
let _e2272 = (((_e2249 * _e2239) - _e2244) * _e2266);
let _e2279 = ((((_e2272 >= 0f) && (_e2272 < _e2102)) && (_e2269 > _e841)) && (_e2269 < _e842));
if _e2279 {
let _e2280 = (_e2272 - 0f);
let _e2284 = global_1.member.member_13.member_6;
let _e2285 = (_e2284 == 0u);
if _e2285 {
phi_4894_ = _e2280;
} else {
let _e2287 = (_e2280 / f32(_e2284));
phi_4181_ = 0u;
phi_4184_ = 0f;
loop {
let _e2289 = phi_4181_;
let _e2291 = phi_4184_;
local_46 = _e2291;
let _e2294 = ((_e2289 < _e2284) && (_e2280 > 0f));
if _e2294 {
let _e2297 = (0f + (_e2287 * f32(_e2289)));
let _e2298 = (_e2297 + _e2287);
let _e2300 = (0.5f * (_e2297 + _e2298));
let _e2301 = (_e2298 - _e2297);
let _e2302 = (0.28867513f * _e2301);
let _e2303 = (_e2300 - _e2302);
let _e2313 = global_1.member.member_13.member_7;
let _e2314 = bitcast<i32>(_e2313);
let _e2318 = global_1.member.member_13.member_8;
let _e2319 = bitcast<i32>(_e2318);
let _e2323 = global_1.member.member_13.member_9;
let _e2324 = bitcast<i32>(_e2323);
let _e2325 = f32(_e2314);
let _e2327 = (_e800.member - _e793.member);
let _e2330 = (((((_e1830 + (_e1868 * _e2303)) - _e793.member) / _e2327) * _e2325) - 0.5f);
let _e2331 = (_e2325 - 1f);
let _e2333 = select(0f, _e2330, (_e2330 > 0f));
let _e2335 = select(_e2331, _e2333, (_e2333 < _e2331));
let _e2336 = f32(_e2319);
let _e2338 = (_e800.member_1 - _e793.member_1);
let _e2341 = (((((_e1842 + (_e1881 * _e2303)) - _e793.member_1) / _e2338) * _e2336) - 0.5f);
let _e2342 = (_e2336 - 1f);
let _e2344 = select(0f, _e2341, (_e2341 > 0f));
let _e2346 = select(_e2342, _e2344, (_e2344 < _e2342));
let _e2347 = f32(_e2324);
let _e2349 = (_e800.member_2 - _e793.member_2);
let _e2352 = (((((_e1855 + (_e1894 * _e2303)) - _e793.member_2) / _e2349) * _e2347) - 0.5f);
let _e2353 = (_e2347 - 1f);
let _e2355 = select(0f, _e2352, (_e2352 > 0f));
let _e2357 = select(_e2353, _e2355, (_e2355 < _e2353));
let _e2359 = select(0f, _e2335, (_e2335 > 0f));
let _e2361 = select(1e6f, _e2359, (_e2359 < 1e6f));
let _e2368 = select(0i, select(select(i32(_e2361), i32(-2147483648), (_e2361 < -2147483600f)), 2147483647i, (_e2361 > 2147483500f)), (_e2361 == _e2361));
let _e2372 = (_e2368 - select(0i, 1i, (_e2361 < f32(_e2368))));
let _e2374 = select(0f, _e2346, (_e2346 > 0f));
let _e2376 = select(1e6f, _e2374, (_e2374 < 1e6f));
let _e2383 = select(0i, select(select(i32(_e2376), i32(-2147483648), (_e2376 < -2147483600f)), 2147483647i, (_e2376 > 2147483500f)), (_e2376 == _e2376));
let _e2387 = (_e2383 - select(0i, 1i, (_e2376 < f32(_e2383))));
let _e2389 = select(0f, _e2357, (_e2357 > 0f));
let _e2391 = select(1e6f, _e2389, (_e2389 < 1e6f));
let _e2398 = select(0i, select(select(i32(_e2391), i32(-2147483648), (_e2391 < -2147483600f)), 2147483647i, (_e2391 > 2147483500f)), (_e2391 == _e2391));
let _e2402 = (_e2398 - select(0i, 1i, (_e2391 < f32(_e2398))));
let _e2406 = (_e2346 - f32(_e2387));
let _e2408 = (_e2357 - f32(_e2402));
local_8 = (_e2335 - f32(_e2372));
let _e2409 = (_e2372 + 1i);
let _e2411 = select(_e2409, 0i, (_e2409 < 0i));
if (_e2411 >= _e2314) {
phi_4319_ = (_e2314 - 1i);
} else {
phi_4319_ = _e2411;
}
let _e2415 = phi_4319_;
local_9 = (_e2415 - _e2372);
let _e2417 = (_e2387 + 1i);
let _e2419 = select(_e2417, 0i, (_e2417 < 0i));
if (_e2419 >= _e2319) {
phi_4332_ = (_e2319 - 1i);
} else {
phi_4332_ = _e2419;
}
let _e2423 = phi_4332_;
let _e2425 = ((_e2423 - _e2387) * _e2314);
let _e2426 = (_e2402 + 1i);
let _e2428 = select(_e2426, 0i, (_e2426 < 0i));
if (_e2428 >= _e2324) {
phi_4346_ = (_e2324 - 1i);
} else {
phi_4346_ = _e2428;
}
let _e2432 = phi_4346_;
let _e2439 = global_1.member.member_13.member_10;
let _e2440 = bitcast<i32>(_e2439);
let _e2445 = ((_e2440 + (((_e2402 * _e2319) + _e2387) * _e2314)) + _e2372);
let _e2447 = (bitcast<i32>(_e142) - 1i);
let _e2449 = select(_e2447, _e2445, (_e2445 < _e2447));
let _e2454 = global_5.member[bitcast<u32>(select(0i, _e2449, (_e2449 > 0i)))];
let _e2455 = local_8;
let _e2458 = local_9;
let _e2459 = (_e2445 + _e2458);
let _e2461 = select(_e2447, _e2459, (_e2459 < _e2447));
let _e2466 = global_5.member[bitcast<u32>(select(0i, _e2461, (_e2461 > 0i)))];
let _e2467 = local_8;
let _e2470 = (1f - _e2406);
let _e2472 = (_e2445 + _e2425);
let _e2474 = select(_e2447, _e2472, (_e2472 < _e2447));
let _e2479 = global_5.member[bitcast<u32>(select(0i, _e2474, (_e2474 > 0i)))];
let _e2480 = local_8;
let _e2483 = local_9;
let _e2484 = (_e2472 + _e2483);
let _e2486 = select(_e2447, _e2484, (_e2484 < _e2447));
let _e2491 = global_5.member[bitcast<u32>(select(0i, _e2486, (_e2486 > 0i)))];
let _e2492 = local_8;
let _e2497 = (_e2445 + (((_e2432 - _e2402) * _e2314) * _e2319));
let _e2499 = select(_e2447, _e2497, (_e2497 < _e2447));
let _e2504 = global_5.member[bitcast<u32>(select(0i, _e2499, (_e2499 > 0i)))];
let _e2505 = local_8;
let _e2508 = local_9;
let _e2509 = (_e2497 + _e2508);
let _e2511 = select(_e2447, _e2509, (_e2509 < _e2447));
let _e2516 = global_5.member[bitcast<u32>(select(0i, _e2511, (_e2511 > 0i)))];
let _e2517 = local_8;
let _e2521 = (_e2497 + _e2425);
let _e2523 = select(_e2447, _e2521, (_e2521 < _e2447));
let _e2528 = global_5.member[bitcast<u32>(select(0i, _e2523, (_e2523 > 0i)))];
let _e2529 = local_8;
let _e2532 = local_9;
let _e2533 = (_e2521 + _e2532);
let _e2535 = select(_e2447, _e2533, (_e2533 < _e2447));
let _e2540 = global_5.member[bitcast<u32>(select(0i, _e2535, (_e2535 > 0i)))];
let _e2541 = local_8;
let _e2550 = (_e2300 + _e2302);
let _e2560 = (((((_e1830 + (_e1868 * _e2550)) - _e793.member) / _e2327) * _e2325) - 0.5f);
let _e2562 = select(0f, _e2560, (_e2560 > 0f));
let _e2564 = select(_e2331, _e2562, (_e2562 < _e2331));
let _e2568 = (((((_e1842 + (_e1881 * _e2550)) - _e793.member_1) / _e2338) * _e2336) - 0.5f);
let _e2570 = select(0f, _e2568, (_e2568 > 0f));
let _e2572 = select(_e2342, _e2570, (_e2570 < _e2342));
let _e2576 = (((((_e1855 + (_e1894 * _e2550)) - _e793.member_2) / _e2349) * _e2347) - 0.5f);
let _e2578 = select(0f, _e2576, (_e2576 > 0f));
let _e2580 = select(_e2353, _e2578, (_e2578 < _e2353));
let _e2582 = select(0f, _e2564, (_e2564 > 0f));
let _e2584 = select(1e6f, _e2582, (_e2582 < 1e6f));
let _e2591 = select(0i, select(select(i32(_e2584), i32(-2147483648), (_e2584 < -2147483600f)), 2147483647i, (_e2584 > 2147483500f)), (_e2584 == _e2584));
let _e2595 = (_e2591 - select(0i, 1i, (_e2584 < f32(_e2591))));
let _e2597 = select(0f, _e2572, (_e2572 > 0f));
let _e2599 = select(1e6f, _e2597, (_e2597 < 1e6f));
let _e2606 = select(0i, select(select(i32(_e2599), i32(-2147483648), (_e2599 < -2147483600f)), 2147483647i, (_e2599 > 2147483500f)), (_e2599 == _e2599));
let _e2610 = (_e2606 - select(0i, 1i, (_e2599 < f32(_e2606))));
let _e2612 = select(0f, _e2580, (_e2580 > 0f));
let _e2614 = select(1e6f, _e2612, (_e2612 < 1e6f));
let _e2621 = select(0i, select(select(i32(_e2614), i32(-2147483648), (_e2614 < -2147483600f)), 2147483647i, (_e2614 > 2147483500f)), (_e2614 == _e2614));
let _e2625 = (_e2621 - select(0i, 1i, (_e2614 < f32(_e2621))));
let _e2629 = (_e2572 - f32(_e2610));
let _e2631 = (_e2580 - f32(_e2625));
local_6 = (_e2564 - f32(_e2595));
let _e2632 = (_e2595 + 1i);
let _e2634 = select(_e2632, 0i, (_e2632 < 0i));
if (_e2634 >= _e2314) {
phi_4662_ = (_e2314 - 1i);
} else {
phi_4662_ = _e2634;
}
let _e2638 = phi_4662_;
local_7 = (_e2638 - _e2595);
let _e2640 = (_e2610 + 1i);
let _e2642 = select(_e2640, 0i, (_e2640 < 0i));
if (_e2642 >= _e2319) {
phi_4675_ = (_e2319 - 1i);
} else {
phi_4675_ = _e2642;
}
let _e2646 = phi_4675_;
let _e2648 = ((_e2646 - _e2610) * _e2314);
let _e2649 = (_e2625 + 1i);
let _e2651 = select(_e2649, 0i, (_e2649 < 0i));
if (_e2651 >= _e2324) {
phi_4689_ = (_e2324 - 1i);
} else {
phi_4689_ = _e2651;
}
let _e2655 = phi_4689_;
let _e2663 = ((_e2440 + (((_e2625 * _e2319) + _e2610) * _e2314)) + _e2595);
let _e2665 = select(_e2447, _e2663, (_e2663 < _e2447));
let _e2670 = global_5.member[bitcast<u32>(select(0i, _e2665, (_e2665 > 0i)))];
let _e2671 = local_6;
let _e2674 = local_7;
let _e2675 = (_e2663 + _e2674);
let _e2677 = select(_e2447, _e2675, (_e2675 < _e2447));
let _e2682 = global_5.member[bitcast<u32>(select(0i, _e2677, (_e2677 > 0i)))];
let _e2683 = local_6;
let _e2686 = (1f - _e2629);
let _e2688 = (_e2663 + _e2648);
let _e2690 = select(_e2447, _e2688, (_e2688 < _e2447));
let _e2695 = global_5.member[bitcast<u32>(select(0i, _e2690, (_e2690 > 0i)))];
let _e2696 = local_6;
let _e2699 = local_7;
let _e2700 = (_e2688 + _e2699);
let _e2702 = select(_e2447, _e2700, (_e2700 < _e2447));
let _e2707 = global_5.member[bitcast<u32>(select(0i, _e2702, (_e2702 > 0i)))];
let _e2708 = local_6;
let _e2713 = (_e2663 + (((_e2655 - _e2625) * _e2314) * _e2319));
let _e2715 = select(_e2447, _e2713, (_e2713 < _e2447));
let _e2720 = global_5.member[bitcast<u32>(select(0i, _e2715, (_e2715 > 0i)))];
let _e2721 = local_6;
let _e2724 = local_7;
let _e2725 = (_e2713 + _e2724);
let _e2727 = select(_e2447, _e2725, (_e2725 < _e2447));
let _e2732 = global_5.member[bitcast<u32>(select(0i, _e2727, (_e2727 > 0i)))];
let _e2733 = local_6;
let _e2737 = (_e2713 + _e2648);
let _e2739 = select(_e2447, _e2737, (_e2737 < _e2447));
let _e2744 = global_5.member[bitcast<u32>(select(0i, _e2739, (_e2739 > 0i)))];
let _e2745 = local_6;
let _e2748 = local_7;
let _e2749 = (_e2737 + _e2748);
let _e2751 = select(_e2447, _e2749, (_e2749 < _e2447));
let _e2756 = global_5.member[bitcast<u32>(select(0i, _e2751, (_e2751 > 0i)))];
let _e2757 = local_6;
phi_4182_ = (_e2289 + 1u);
phi_4185_ = (_e2291 + ((0.5f * (((((((_e2454 * (1f - _e2455)) + (_e2466 * _e2467)) * _e2470) + (((_e2479 * (1f - _e2480)) + (_e2491 * _e2492)) * _e2406)) * (1f - _e2408)) + (((((_e2504 * (1f - _e2505)) + (_e2516 * _e2517)) * _e2470) + (((_e2528 * (1f - _e2529)) + (_e2540 * _e2541)) * _e2406)) * _e2408)) + ((((((_e2670 * (1f - _e2671)) + (_e2682 * _e2683)) * _e2686) + (((_e2695 * (1f - _e2696)) + (_e2707 * _e2708)) * _e2629)) * (1f - _e2631)) + (((((_e2720 * (1f - _e2721)) + (_e2732 * _e2733)) * _e2686) + (((_e2744 * (1f - _e2745)) + (_e2756 * _e2757)) * _e2629)) * _e2631)))) * _e2301));
} else {
phi_4182_ = u32();
phi_4185_ = f32();
}
let _e2772 = phi_4182_;
let _e2774 = phi_4185_;
continue;
continuing {
phi_4181_ = _e2772;
phi_4184_ = _e2774;
break if !(_e2294);
}
}
let _e4074 = local_46;
phi_4894_ = _e4074;
}
let _e2777 = phi_4894_;
let _e2778 = (_e2269 - _e841);
if _e2285 {
phi_5620_ = _e2778;
} else {
let _e2780 = (_e2778 / f32(_e2284));
phi_4907_ = 0u;
phi_4910_ = 0f;
loop {
let _e2782 = phi_4907_;
let _e2784 = phi_4910_;
local_47 = _e2784;
let _e2787 = ((_e2782 < _e2284) && (_e2778 > 0f));
if _e2787 {
let _e2790 = (_e841 + (_e2780 * f32(_e2782)));
let _e2791 = (_e2790 + _e2780);
let _e2793 = (0.5f * (_e2790 + _e2791));
let _e2794 = (_e2791 - _e2790);
let _e2795 = (0.28867513f * _e2794);
let _e2796 = (_e2793 - _e2795);
let _e2806 = global_1.member.member_13.member_7;
let _e2807 = bitcast<i32>(_e2806);
let _e2811 = global_1.member.member_13.member_8;
let _e2812 = bitcast<i32>(_e2811);
let _e2816 = global_1.member.member_13.member_9;
let _e2817 = bitcast<i32>(_e2816);
let _e2818 = f32(_e2807);
let _e2820 = (_e800.member - _e793.member);
let _e2823 = (((((_e759 + (_e460 * _e2796)) - _e793.member) / _e2820) * _e2818) - 0.5f);
let _e2824 = (_e2818 - 1f);
let _e2826 = select(0f, _e2823, (_e2823 > 0f));
let _e2828 = select(_e2824, _e2826, (_e2826 < _e2824));
let _e2829 = f32(_e2812);
let _e2831 = (_e800.member_1 - _e793.member_1);
let _e2834 = (((((_e760 + (_e471 * _e2796)) - _e793.member_1) / _e2831) * _e2829) - 0.5f);
let _e2835 = (_e2829 - 1f);
let _e2837 = select(0f, _e2834, (_e2834 > 0f));
let _e2839 = select(_e2835, _e2837, (_e2837 < _e2835));
let _e2840 = f32(_e2817);
let _e2842 = (_e800.member_2 - _e793.member_2);
let _e2845 = (((((_e761 + (_e482 * _e2796)) - _e793.member_2) / _e2842) * _e2840) - 0.5f);
let _e2846 = (_e2840 - 1f);
let _e2848 = select(0f, _e2845, (_e2845 > 0f));
let _e2850 = select(_e2846, _e2848, (_e2848 < _e2846));
let _e2852 = select(0f, _e2828, (_e2828 > 0f));
let _e2854 = select(1e6f, _e2852, (_e2852 < 1e6f));
let _e2861 = select(0i, select(select(i32(_e2854), i32(-2147483648), (_e2854 < -2147483600f)), 2147483647i, (_e2854 > 2147483500f)), (_e2854 == _e2854));
let _e2865 = (_e2861 - select(0i, 1i, (_e2854 < f32(_e2861))));
let _e2867 = select(0f, _e2839, (_e2839 > 0f));
let _e2869 = select(1e6f, _e2867, (_e2867 < 1e6f));
let _e2876 = select(0i, select(select(i32(_e2869), i32(-2147483648), (_e2869 < -2147483600f)), 2147483647i, (_e2869 > 2147483500f)), (_e2869 == _e2869));
let _e2880 = (_e2876 - select(0i, 1i, (_e2869 < f32(_e2876))));
let _e2882 = select(0f, _e2850, (_e2850 > 0f));
let _e2884 = select(1e6f, _e2882, (_e2882 < 1e6f));
let _e2891 = select(0i, select(select(i32(_e2884), i32(-2147483648), (_e2884 < -2147483600f)), 2147483647i, (_e2884 > 2147483500f)), (_e2884 == _e2884));
let _e2895 = (_e2891 - select(0i, 1i, (_e2884 < f32(_e2891))));
let _e2899 = (_e2839 - f32(_e2880));
let _e2901 = (_e2850 - f32(_e2895));
local_4 = (_e2828 - f32(_e2865));
let _e2902 = (_e2865 + 1i);
let _e2904 = select(_e2902, 0i, (_e2902 < 0i));
if (_e2904 >= _e2807) {
phi_5045_ = (_e2807 - 1i);
} else {
phi_5045_ = _e2904;
}
let _e2908 = phi_5045_;
local_5 = (_e2908 - _e2865);
let _e2910 = (_e2880 + 1i);
let _e2912 = select(_e2910, 0i, (_e2910 < 0i));
if (_e2912 >= _e2812) {
phi_5058_ = (_e2812 - 1i);
} else {
phi_5058_ = _e2912;
}
let _e2916 = phi_5058_;
let _e2918 = ((_e2916 - _e2880) * _e2807);
let _e2919 = (_e2895 + 1i);
let _e2921 = select(_e2919, 0i, (_e2919 < 0i));
if (_e2921 >= _e2817) {
phi_5072_ = (_e2817 - 1i);
} else {
phi_5072_ = _e2921;
}
let _e2925 = phi_5072_;
let _e2932 = global_1.member.member_13.member_10;
let _e2933 = bitcast<i32>(_e2932);
let _e2938 = ((_e2933 + (((_e2895 * _e2812) + _e2880) * _e2807)) + _e2865);
let _e2940 = (bitcast<i32>(_e142) - 1i);
let _e2942 = select(_e2940, _e2938, (_e2938 < _e2940));
let _e2947 = global_5.member[bitcast<u32>(select(0i, _e2942, (_e2942 > 0i)))];
let _e2948 = local_4;
let _e2951 = local_5;
let _e2952 = (_e2938 + _e2951);
let _e2954 = select(_e2940, _e2952, (_e2952 < _e2940));
let _e2959 = global_5.member[bitcast<u32>(select(0i, _e2954, (_e2954 > 0i)))];
let _e2960 = local_4;
let _e2963 = (1f - _e2899);
let _e2965 = (_e2938 + _e2918);
let _e2967 = select(_e2940, _e2965, (_e2965 < _e2940));
let _e2972 = global_5.member[bitcast<u32>(select(0i, _e2967, (_e2967 > 0i)))];
let _e2973 = local_4;
let _e2976 = local_5;
let _e2977 = (_e2965 + _e2976);
let _e2979 = select(_e2940, _e2977, (_e2977 < _e2940));
let _e2984 = global_5.member[bitcast<u32>(select(0i, _e2979, (_e2979 > 0i)))];
let _e2985 = local_4;
let _e2990 = (_e2938 + (((_e2925 - _e2895) * _e2807) * _e2812));
let _e2992 = select(_e2940, _e2990, (_e2990 < _e2940));
let _e2997 = global_5.member[bitcast<u32>(select(0i, _e2992, (_e2992 > 0i)))];
let _e2998 = local_4;
let _e3001 = local_5;
let _e3002 = (_e2990 + _e3001);
let _e3004 = select(_e2940, _e3002, (_e3002 < _e2940));
let _e3009 = global_5.member[bitcast<u32>(select(0i, _e3004, (_e3004 > 0i)))];
let _e3010 = local_4;
let _e3014 = (_e2990 + _e2918);
let _e3016 = select(_e2940, _e3014, (_e3014 < _e2940));
let _e3021 = global_5.member[bitcast<u32>(select(0i, _e3016, (_e3016 > 0i)))];
let _e3022 = local_4;
let _e3025 = local_5;
let _e3026 = (_e3014 + _e3025);
let _e3028 = select(_e2940, _e3026, (_e3026 < _e2940));
let _e3033 = global_5.member[bitcast<u32>(select(0i, _e3028, (_e3028 > 0i)))];
let _e3034 = local_4;
let _e3043 = (_e2793 + _e2795);
let _e3053 = (((((_e759 + (_e460 * _e3043)) - _e793.member) / _e2820) * _e2818) - 0.5f);
let _e3055 = select(0f, _e3053, (_e3053 > 0f));
let _e3057 = select(_e2824, _e3055, (_e3055 < _e2824));
let _e3061 = (((((_e760 + (_e471 * _e3043)) - _e793.member_1) / _e2831) * _e2829) - 0.5f);
let _e3063 = select(0f, _e3061, (_e3061 > 0f));
let _e3065 = select(_e2835, _e3063, (_e3063 < _e2835));
let _e3069 = (((((_e761 + (_e482 * _e3043)) - _e793.member_2) / _e2842) * _e2840) - 0.5f);
let _e3071 = select(0f, _e3069, (_e3069 > 0f));
let _e3073 = select(_e2846, _e3071, (_e3071 < _e2846));
let _e3075 = select(0f, _e3057, (_e3057 > 0f));
let _e3077 = select(1e6f, _e3075, (_e3075 < 1e6f));
let _e3084 = select(0i, select(select(i32(_e3077), i32(-2147483648), (_e3077 < -2147483600f)), 2147483647i, (_e3077 > 2147483500f)), (_e3077 == _e3077));
let _e3088 = (_e3084 - select(0i, 1i, (_e3077 < f32(_e3084))));
let _e3090 = select(0f, _e3065, (_e3065 > 0f));
let _e3092 = select(1e6f, _e3090, (_e3090 < 1e6f));
let _e3099 = select(0i, select(select(i32(_e3092), i32(-2147483648), (_e3092 < -2147483600f)), 2147483647i, (_e3092 > 2147483500f)), (_e3092 == _e3092));
let _e3103 = (_e3099 - select(0i, 1i, (_e3092 < f32(_e3099))));
let _e3105 = select(0f, _e3073, (_e3073 > 0f));
let _e3107 = select(1e6f, _e3105, (_e3105 < 1e6f));
let _e3114 = select(0i, select(select(i32(_e3107), i32(-2147483648), (_e3107 < -2147483600f)), 2147483647i, (_e3107 > 2147483500f)), (_e3107 == _e3107));
let _e3118 = (_e3114 - select(0i, 1i, (_e3107 < f32(_e3114))));
let _e3122 = (_e3065 - f32(_e3103));
let _e3124 = (_e3073 - f32(_e3118));
local_2 = (_e3057 - f32(_e3088));
let _e3125 = (_e3088 + 1i);
let _e3127 = select(_e3125, 0i, (_e3125 < 0i));
if (_e3127 >= _e2807) {
phi_5388_ = (_e2807 - 1i);
} else {
phi_5388_ = _e3127;
}
let _e3131 = phi_5388_;
local_3 = (_e3131 - _e3088);
let _e3133 = (_e3103 + 1i);
let _e3135 = select(_e3133, 0i, (_e3133 < 0i));
if (_e3135 >= _e2812) {
phi_5401_ = (_e2812 - 1i);
} else {
phi_5401_ = _e3135;
}
let _e3139 = phi_5401_;
let _e3141 = ((_e3139 - _e3103) * _e2807);
let _e3142 = (_e3118 + 1i);
let _e3144 = select(_e3142, 0i, (_e3142 < 0i));
if (_e3144 >= _e2817) {
phi_5415_ = (_e2817 - 1i);
} else {
phi_5415_ = _e3144;
}
let _e3148 = phi_5415_;
let _e3156 = ((_e2933 + (((_e3118 * _e2812) + _e3103) * _e2807)) + _e3088);
let _e3158 = select(_e2940, _e3156, (_e3156 < _e2940));
let _e3163 = global_5.member[bitcast<u32>(select(0i, _e3158, (_e3158 > 0i)))];
let _e3164 = local_2;
let _e3167 = local_3;
let _e3168 = (_e3156 + _e3167);
let _e3170 = select(_e2940, _e3168, (_e3168 < _e2940));
let _e3175 = global_5.member[bitcast<u32>(select(0i, _e3170, (_e3170 > 0i)))];
let _e3176 = local_2;
let _e3179 = (1f - _e3122);
let _e3181 = (_e3156 + _e3141);
let _e3183 = select(_e2940, _e3181, (_e3181 < _e2940));
let _e3188 = global_5.member[bitcast<u32>(select(0i, _e3183, (_e3183 > 0i)))];
let _e3189 = local_2;
let _e3192 = local_3;
let _e3193 = (_e3181 + _e3192);
let _e3195 = select(_e2940, _e3193, (_e3193 < _e2940));
let _e3200 = global_5.member[bitcast<u32>(select(0i, _e3195, (_e3195 > 0i)))];
let _e3201 = local_2;
let _e3206 = (_e3156 + (((_e3148 - _e3118) * _e2807) * _e2812));
let _e3208 = select(_e2940, _e3206, (_e3206 < _e2940));
let _e3213 = global_5.member[bitcast<u32>(select(0i, _e3208, (_e3208 > 0i)))];
let _e3214 = local_2;
let _e3217 = local_3;
let _e3218 = (_e3206 + _e3217);
let _e3220 = select(_e2940, _e3218, (_e3218 < _e2940));
let _e3225 = global_5.member[bitcast<u32>(select(0i, _e3220, (_e3220 > 0i)))];
let _e3226 = local_2;
let _e3230 = (_e3206 + _e3141);
let _e3232 = select(_e2940, _e3230, (_e3230 < _e2940));
let _e3237 = global_5.member[bitcast<u32>(select(0i, _e3232, (_e3232 > 0i)))];
let _e3238 = local_2;
let _e3241 = local_3;
let _e3242 = (_e3230 + _e3241);
let _e3244 = select(_e2940, _e3242, (_e3242 < _e2940));
let _e3249 = global_5.member[bitcast<u32>(select(0i, _e3244, (_e3244 > 0i)))];
let _e3250 = local_2;
phi_4908_ = (_e2782 + 1u);
phi_4911_ = (_e2784 + ((0.5f * (((((((_e2947 * (1f - _e2948)) + (_e2959 * _e2960)) * _e2963) + (((_e2972 * (1f - _e2973)) + (_e2984 * _e2985)) * _e2899)) * (1f - _e2901)) + (((((_e2997 * (1f - _e2998)) + (_e3009 * _e3010)) * _e2963) + (((_e3021 * (1f - _e3022)) + (_e3033 * _e3034)) * _e2899)) * _e2901)) + ((((((_e3163 * (1f - _e3164)) + (_e3175 * _e3176)) * _e3179) + (((_e3188 * (1f - _e3189)) + (_e3200 * _e3201)) * _e3122)) * (1f - _e3124)) + (((((_e3213 * (1f - _e3214)) + (_e3225 * _e3226)) * _e3179) + (((_e3237 * (1f - _e3238)) + (_e3249 * _e3250)) * _e3122)) * _e3124)))) * _e2794));
} else {
phi_4908_ = u32();
phi_4911_ = f32();
}
let _e3265 = phi_4908_;
let _e3267 = phi_4911_;
continue;
continuing {
phi_4907_ = _e3265;
phi_4910_ = _e3267;
break if !(_e2787);
}
}
let _e4087 = local_47;
phi_5620_ = _e4087;
}
let _e3270 = phi_5620_;
if _e2285 {
phi_5969_ = 1f;
} else {
let _e3280 = global_1.member.member_13.member_7;
let _e3281 = bitcast<i32>(_e3280);
let _e3285 = global_1.member.member_13.member_8;
let _e3286 = bitcast<i32>(_e3285);
let _e3290 = global_1.member.member_13.member_9;
let _e3291 = bitcast<i32>(_e3290);
let _e3292 = f32(_e3281);
let _e3297 = (((((_e759 + (_e460 * _e2269)) - _e793.member) / (_e800.member - _e793.member)) * _e3292) - 0.5f);
let _e3298 = (_e3292 - 1f);
let _e3300 = select(0f, _e3297, (_e3297 > 0f));
let _e3302 = select(_e3298, _e3300, (_e3300 < _e3298));
let _e3303 = f32(_e3286);
let _e3308 = (((((_e760 + (_e471 * _e2269)) - _e793.member_1) / (_e800.member_1 - _e793.member_1)) * _e3303) - 0.5f);
let _e3309 = (_e3303 - 1f);
let _e3311 = select(0f, _e3308, (_e3308 > 0f));
let _e3313 = select(_e3309, _e3311, (_e3311 < _e3309));
let _e3314 = f32(_e3291);
let _e3319 = (((((_e761 + (_e482 * _e2269)) - _e793.member_2) / (_e800.member_2 - _e793.member_2)) * _e3314) - 0.5f);
let _e3320 = (_e3314 - 1f);
let _e3322 = select(0f, _e3319, (_e3319 > 0f));
let _e3324 = select(_e3320, _e3322, (_e3322 < _e3320));
let _e3326 = select(0f, _e3302, (_e3302 > 0f));
let _e3328 = select(1e6f, _e3326, (_e3326 < 1e6f));
let _e3335 = select(0i, select(select(i32(_e3328), i32(-2147483648), (_e3328 < -2147483600f)), 2147483647i, (_e3328 > 2147483500f)), (_e3328 == _e3328));
let _e3339 = (_e3335 - select(0i, 1i, (_e3328 < f32(_e3335))));
let _e3341 = select(0f, _e3313, (_e3313 > 0f));
let _e3343 = select(1e6f, _e3341, (_e3341 < 1e6f));
let _e3350 = select(0i, select(select(i32(_e3343), i32(-2147483648), (_e3343 < -2147483600f)), 2147483647i, (_e3343 > 2147483500f)), (_e3343 == _e3343));
let _e3354 = (_e3350 - select(0i, 1i, (_e3343 < f32(_e3350))));
let _e3356 = select(0f, _e3324, (_e3324 > 0f));
let _e3358 = select(1e6f, _e3356, (_e3356 < 1e6f));
let _e3365 = select(0i, select(select(i32(_e3358), i32(-2147483648), (_e3358 < -2147483600f)), 2147483647i, (_e3358 > 2147483500f)), (_e3358 == _e3358));
let _e3369 = (_e3365 - select(0i, 1i, (_e3358 < f32(_e3365))));
let _e3373 = (_e3313 - f32(_e3354));
let _e3375 = (_e3324 - f32(_e3369));
local = (_e3302 - f32(_e3339));
let _e3376 = (_e3339 + 1i);
let _e3378 = select(_e3376, 0i, (_e3376 < 0i));
if (_e3378 >= _e3281) {
phi_5742_ = (_e3281 - 1i);
} else {
phi_5742_ = _e3378;
}
let _e3382 = phi_5742_;
local_1 = (_e3382 - _e3339);
let _e3384 = (_e3354 + 1i);
let _e3386 = select(_e3384, 0i, (_e3384 < 0i));
if (_e3386 >= _e3286) {
phi_5755_ = (_e3286 - 1i);
} else {
phi_5755_ = _e3386;
}
let _e3390 = phi_5755_;
let _e3392 = ((_e3390 - _e3354) * _e3281);
let _e3393 = (_e3369 + 1i);
let _e3395 = select(_e3393, 0i, (_e3393 < 0i));
if (_e3395 >= _e3291) {
phi_5769_ = (_e3291 - 1i);
} else {
phi_5769_ = _e3395;
}
let _e3399 = phi_5769_;
let _e3406 = global_1.member.member_13.member_10;
let _e3412 = ((bitcast<i32>(_e3406) + (((_e3369 * _e3286) + _e3354) * _e3281)) + _e3339);
let _e3414 = (bitcast<i32>(_e142) - 1i);
let _e3416 = select(_e3414, _e3412, (_e3412 < _e3414));
let _e3421 = global_5.member[bitcast<u32>(select(0i, _e3416, (_e3416 > 0i)))];
let _e3422 = local;
let _e3425 = local_1;
let _e3426 = (_e3412 + _e3425);
let _e3428 = select(_e3414, _e3426, (_e3426 < _e3414));
let _e3433 = global_5.member[bitcast<u32>(select(0i, _e3428, (_e3428 > 0i)))];
let _e3434 = local;
let _e3437 = (1f - _e3373);
let _e3439 = (_e3412 + _e3392);
let _e3441 = select(_e3414, _e3439, (_e3439 < _e3414));
let _e3446 = global_5.member[bitcast<u32>(select(0i, _e3441, (_e3441 > 0i)))];
let _e3447 = local;
let _e3450 = local_1;
let _e3451 = (_e3439 + _e3450);
let _e3453 = select(_e3414, _e3451, (_e3451 < _e3414));
let _e3458 = global_5.member[bitcast<u32>(select(0i, _e3453, (_e3453 > 0i)))];
let _e3459 = local;
let _e3464 = (_e3412 + (((_e3399 - _e3369) * _e3281) * _e3286));
let _e3466 = select(_e3414, _e3464, (_e3464 < _e3414));
let _e3471 = global_5.member[bitcast<u32>(select(0i, _e3466, (_e3466 > 0i)))];
let _e3472 = local;
let _e3475 = local_1;
let _e3476 = (_e3464 + _e3475);
let _e3478 = select(_e3414, _e3476, (_e3476 < _e3414));
let _e3483 = global_5.member[bitcast<u32>(select(0i, _e3478, (_e3478 > 0i)))];
let _e3484 = local;
let _e3488 = (_e3464 + _e3392);
let _e3490 = select(_e3414, _e3488, (_e3488 < _e3414));
let _e3495 = global_5.member[bitcast<u32>(select(0i, _e3490, (_e3490 > 0i)))];
let _e3496 = local;
let _e3499 = local_1;
let _e3500 = (_e3488 + _e3499);
let _e3502 = select(_e3414, _e3500, (_e3500 < _e3414));
let _e3507 = global_5.member[bitcast<u32>(select(0i, _e3502, (_e3502 > 0i)))];
let _e3508 = local;
phi_5969_ = ((((((_e3421 * (1f - _e3422)) + (_e3433 * _e3434)) * _e3437) + (((_e3446 * (1f - _e3447)) + (_e3458 * _e3459)) * _e3373)) * (1f - _e3375)) + (((((_e3471 * (1f - _e3472)) + (_e3483 * _e3484)) * _e3437) + (((_e3495 * (1f - _e3496)) + (_e3507 * _e3508)) * _e3373)) * _e3375));
}
let _e3518 = phi_5969_;
let _e3519 = (_e2777 + _e3270);
let _e3523 = global_1.member.member_13.member;
let _e3528 = -((_e3523.member * _e3519));
let _e3530 = select(-87f, _e3528, (_e3528 > -87f));
let _e3532 = select(88f, _e3530, (_e3530 < 88f));
let _e3534 = ((_e3532 * 1.442695f) + 0.5f);
let _e3536 = select(-127f, _e3534, (_e3534 > -127f));
let _e3538 = select(128f, _e3536, (_e3536 < 128f));
let _e3545 = select(0i, select(select(i32(_e3538), i32(-2147483648), (_e3538 < -2147483600f)), 2147483647i, (_e3538 > 2147483500f)), (_e3538 == _e3538));
let _e3549 = (_e3545 - select(0i, 1i, (_e3538 < f32(_e3545))));
let _e3550 = f32(_e3549);
let _e3554 = ((_e3532 - (_e3550 * 0.6933594f)) - (_e3550 * -2.1219444e-4f));
let _e3576 = -((_e3523.member_1 * _e3519));
let _e3578 = select(-87f, _e3576, (_e3576 > -87f));
let _e3580 = select(88f, _e3578, (_e3578 < 88f));
let _e3582 = ((_e3580 * 1.442695f) + 0.5f);
let _e3584 = select(-127f, _e3582, (_e3582 > -127f));
let _e3586 = select(128f, _e3584, (_e3584 < 128f));
let _e3593 = select(0i, select(select(i32(_e3586), i32(-2147483648), (_e3586 < -2147483600f)), 2147483647i, (_e3586 > 2147483500f)), (_e3586 == _e3586));
let _e3597 = (_e3593 - select(0i, 1i, (_e3586 < f32(_e3593))));
let _e3598 = f32(_e3597);
let _e3602 = ((_e3580 - (_e3598 * 0.6933594f)) - (_e3598 * -2.1219444e-4f));
let _e3624 = -((_e3523.member_2 * _e3519));
let _e3626 = select(-87f, _e3624, (_e3624 > -87f));
let _e3628 = select(88f, _e3626, (_e3626 < 88f));
let _e3630 = ((_e3628 * 1.442695f) + 0.5f);
let _e3632 = select(-127f, _e3630, (_e3630 > -127f));
let _e3634 = select(128f, _e3632, (_e3632 < 128f));
let _e3641 = select(0i, select(select(i32(_e3634), i32(-2147483648), (_e3634 < -2147483600f)), 2147483647i, (_e3634 > 2147483500f)), (_e3634 == _e3634));
let _e3645 = (_e3641 - select(0i, 1i, (_e3634 < f32(_e3641))));
let _e3646 = f32(_e3645);
let _e3650 = ((_e3628 - (_e3646 * 0.6933594f)) - (_e3646 * -2.1219444e-4f));
let _e3671 = -(_e2249);
let _e3675 = global_1.member.member_13.member_2;
let _e3676 = (_e3675 * _e3675);
let _e3680 = ((1f + _e3676) - ((2f * _e3675) * _e3671));
let _e3682 = select(1e-9f, _e3680, (_e3680 > 1e-9f));
let _e3695 = global_1.member.member_13.member_3;
if (_e3695 == 2u) {
let _e3700 = (0.5f - (0.5f * _e3671));
let _e3702 = select(0f, _e3700, (_e3700 > 0f));
let _e3706 = (sqrt(select(0f, _e3702, (_e3702 > 0f))) * 255f);
let _e3707 = (255f - 1f);
let _e3709 = select(0f, _e3706, (_e3706 > 0f));
let _e3711 = select(_e3707, _e3709, (_e3709 < _e3707));
let _e3718 = select(0i, select(select(i32(_e3711), i32(-2147483648), (_e3711 < -2147483600f)), 2147483647i, (_e3711 > 2147483500f)), (_e3711 == _e3711));
let _e3722 = (_e3718 - select(0i, 1i, (_e3711 < f32(_e3718))));
let _e3726 = global_1.member.member_13.member_11;
let _e3727 = bitcast<i32>(_e3726);
let _e3728 = (_e3727 + _e3722);
let _e3730 = (bitcast<i32>(_e142) - 1i);
let _e3732 = select(_e3730, _e3728, (_e3728 < _e3730));
let _e3737 = global_5.member[bitcast<u32>(select(0i, _e3732, (_e3732 > 0i)))];
let _e3739 = (_e3727 + (_e3722 + 1i));
let _e3741 = select(_e3730, _e3739, (_e3739 < _e3730));
let _e3746 = global_5.member[bitcast<u32>(select(0i, _e3741, (_e3741 > 0i)))];
phi_6312_ = (_e3737 + ((_e3746 - _e3737) * (_e3706 - f32(_e3722))));
} else {
phi_6312_ = select(((1f - _e3676) / (_e3682 * sqrt(select(0f, _e3682, (_e3682 > 0f))))), (0.75f * (1f + (_e3671 * _e3671))), (_e3695 == 1u));
}
let _e3753 = phi_6312_;
let _e3756 = (1e-4f * _e2227);
let _e3758 = select(_e2177, _e2148, (_e2148 > _e2177));
let _e3760 = select(_e3756, _e3758, (_e3758 > _e3756));
let _e3762 = select(_e2177, _e2148, (_e2148 < _e2177));
let _e3764 = select(_e3756, _e3762, (_e3762 > _e3756));
let _e3766 = (0.5f * (_e3760 + _e3764));
let _e3767 = (0.5f / _e3764);
let _e3768 = (1f / _e3760);
let _e3770 = (0.5f * _e2227);
let _e3771 = (_e2119 + _e3770);
let _e3772 = -(_e3771);
let _e3775 = (_e3766 - select(_e3772, _e3771, (_e3771 > _e3772)));
let _e3777 = select(0f, _e3775, (_e3775 > 0f));
let _e3779 = select(_e3764, _e3777, (_e3777 < _e3764));
let _e3782 = (_e3775 - _e3764);
let _e3786 = (((_e3779 * (_e3779 * _e3767)) + select(0f, _e3782, (_e3782 > 0f))) * _e3768);
let _e3790 = (_e2119 - _e3770);
let _e3791 = -(_e3790);
let _e3794 = (_e3766 - select(_e3791, _e3790, (_e3790 > _e3791)));
let _e3796 = select(0f, _e3794, (_e3794 > 0f));
let _e3798 = select(_e3764, _e3796, (_e3796 < _e3764));
let _e3801 = (_e3794 - _e3764);
let _e3805 = (((_e3798 * (_e3798 * _e3767)) + select(0f, _e3801, (_e3801 > 0f))) * _e3768);
let _e3812 = (((_e3753 * (0.25f / 3.1415927f)) * ((select(_e3786, (1f - _e3786), (_e3771 >= 0f)) - select(_e3805, (1f - _e3805), (_e3790 >= 0f))) * (1f / _e2227))) * _e3518);
let _e3819 = global_1.member.member_13.member_1;
phi_6430_ = vec3<f32>((((_e2063 * ((1f + (_e3554 * (1f + (_e3554 * (0.5f + (_e3554 * (0.16666667f + (_e3554 * (0.041666668f + (_e3554 * (0.008333334f + (_e3554 * (0.001388889f + (_e3554 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3549 + 127i)) << bitcast<u32>(23i))))) * _e3819.member) * _e3812), (((_e2076 * ((1f + (_e3602 * (1f + (_e3602 * (0.5f + (_e3602 * (0.16666667f + (_e3602 * (0.041666668f + (_e3602 * (0.008333334f + (_e3602 * (0.001388889f + (_e3602 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3597 + 127i)) << bitcast<u32>(23i))))) * _e3819.member_1) * _e3812), (((_e2089 * ((1f + (_e3650 * (1f + (_e3650 * (0.5f + (_e3650 * (0.16666667f + (_e3650 * (0.041666668f + (_e3650 * (0.008333334f + (_e3650 * (0.001388889f + (_e3650 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3645 + 127i)) << bitcast<u32>(23i))))) * _e3819.member_2) * _e3812));
} else {
phi_6430_ = vec3<f32>();
}
let _e3831 = phi_6430_;
phi_6432_ = _e3831;
phi_6433_ = select(true, false, _e2279);
}
let _e3834 = phi_6432_;
let _e3836 = phi_6433_;
let _e3838 = select(_e3834, vec3<f32>(0f, 0f, 0f), vec3(_e3836));
let _e3839 = select(1f, 0f, _e1060);
let _e3853 = select(0f, 1f, _e1060);
phi_6476_ = vec3<f32>((_e1750.x + (_e3838.x * _e3853)), (_e1750.y + (_e3838.y * _e3853)), (_e1750.z + (_e3838.z * _e3853)));
phi_6477_ = vec3<f32>((_e1752.x + (_e3838.x * _e3839)), (_e1752.y + (_e3838.y * _e3839)), (_e1752.z + (_e3838.z * _e3839)));
}
let _e3865 = phi_6476_;
let _e3867 = phi_6477_;
phi_3252_ = _e3865;
phi_3255_ = _e3867;
phi_3257_ = (_e1754 + 1u);
}
let _e3870 = phi_3252_;
let _e3872 = phi_3255_;
let _e3874 = phi_3257_;
continue;
continuing {
phi_3251_ = _e3870;
phi_3254_ = _e3872;
phi_3256_ = _e3874;
break if !(select(true, false, _e1758));
}
}
let _e3877 = local_23.member_1;
phi_6487_ = type_17(_e1069.member, (_e1069.member_1 + 1u));
loop {
let _e3881 = phi_6487_;
local_50 = _e3881;
let _e3887 = (((_e3881.member_1 & 3u) == 0u) && (_e3881.member < _e3877));
if _e3887 {
phi_6488_ = type_17((_e3881.member + 1u), (_e3881.member_1 >> bitcast<u32>(2i)));
} else {
phi_6488_ = type_17();
}
let _e3893 = phi_6488_;
continue;
continuing {
phi_6487_ = _e3893;
break if !(_e3887);
}
}
let _e4105 = local_48;
phi_6509_ = _e4105;
let _e4108 = local_49;
phi_6510_ = _e4108;
let _e4111 = local_50;
phi_6511_ = _e4111;
}
let _e3900 = phi_6509_;
let _e3902 = phi_6510_;
let _e3904 = phi_6511_;
phi_2088_ = _e3900;
phi_2091_ = _e3902;
phi_2093_ = _e3904;
} else {
phi_2088_ = vec3<f32>();
phi_2091_ = vec3<f32>();
phi_2093_ = type_17();
}
let _e3906 = phi_2088_;
let _e3908 = phi_2091_;
let _e3910 = phi_2093_;
continue;
continuing {
phi_2087_ = _e3906;
phi_2090_ = _e3908;
phi_2092_ = _e3910;
break if !(_e1077);
}
}
let _e4117 = local_51;
phi_1888_ = _e4117;
let _e4120 = local_52;
phi_1891_ = _e4120;
phi_1893_ = (_e898 + 1u);
} else {
phi_1888_ = vec3<f32>();
phi_1891_ = vec3<f32>();
phi_1893_ = u32();
}
let _e3914 = phi_1888_;
let _e3916 = phi_1891_;
let _e3918 = phi_1893_;
continue;
continuing {
phi_1887_ = _e3914;
phi_1890_ = _e3916;
phi_1892_ = _e3918;
break if !(_e903);
}
}
let _e3921 = local_39;
let _e3925 = local_40;
let _e3929 = local_41;
let _e3936 = local_42;
let _e3940 = local_43;
let _e3944 = local_44;
phi_6562_ = array<f32, 19>(_e167, _e177, _e188, _e199, _e210, _e221, _e232, _e243, _e254, (_e265 + (_e3921.x * _e763)), (_e276 + (_e3925.y * _e764)), (_e287 + (_e3929.z * _e765)), (_e298 + (_e3936.x * _e763)), (_e309 + (_e3940.y * _e764)), (_e320 + (_e3944.z * _e765)), _e331, _e342, _e353, _e364);
}
let _e3952 = phi_6562_;
global_6.member[_e156] = _e3952[0];
global_6.member[_e168] = _e3952[1];
global_6.member[_e179] = _e3952[2];
global_6.member[_e190] = _e3952[3];
global_6.member[_e201] = _e3952[4];
global_6.member[_e212] = _e3952[5];
global_6.member[_e223] = _e3952[6];
global_6.member[_e234] = _e3952[7];
global_6.member[_e245] = _e3952[8];
global_6.member[_e256] = _e3952[9];
global_6.member[_e267] = _e3952[10];
global_6.member[_e278] = _e3952[11];
global_6.member[_e289] = _e3952[12];
global_6.member[_e300] = _e3952[13];
global_6.member[_e311] = _e3952[14];
global_6.member[_e322] = _e3952[15];
global_6.member[_e333] = _e3952[16];
global_6.member[_e344] = _e3952[17];
global_6.member[_e355] = _e3952[18];
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
