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
struct type_16 {
member: u32,
member_1: u32,
}
struct type_17 {
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
struct type_18 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
}
struct type_19 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
}
struct type_20 {
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
struct type_21 {
member: type_2,
member_1: type_16,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_17,
member_12: type_18,
member_13: type_19,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_20,
}
struct type_22 {
member: type_21,
}
struct type_23 {
member: f32,
member_1: f32,
}
struct type_26 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_22;
@group(0) @binding(1)
var<storage> global_2: type_13;
@group(0) @binding(2)
var<storage> global_3: type_13;
@group(0) @binding(3)
var<storage> global_4: type_13;
@group(0) @binding(4)
var<storage, read_write> global_5: type_26;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var local_10: i32;
var local_11: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var local_15: i32;
var local_16: i32;
var local_17: i32;
var local_18: i32;
var local_19: i32;
var local_20: i32;
var local_21: i32;
var local_22: i32;
var local_23: i32;
var local_24: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var local_28: i32;
var local_29: i32;
var local_30: i32;
var local_31: i32;
var phi_1532_: type_23;
var phi_1942_: f32;
var phi_1945_: u32;
var phi_1943_: f32;
var phi_1946_: u32;
var local_32: u32;
var phi_1975_: f32;
var phi_1978_: u32;
var phi_1976_: f32;
var phi_1979_: u32;
var phi_1990_: u32;
var phi_2042_: f32;
var phi_2045_: u32;
var phi_2043_: f32;
var phi_2046_: u32;
var local_33: u32;
var phi_2075_: f32;
var phi_2078_: u32;
var phi_2076_: f32;
var phi_2079_: u32;
var phi_2090_: u32;
var phi_2101_: u32;
var phi_2141_: f32;
var phi_2144_: u32;
var phi_2142_: f32;
var phi_2145_: u32;
var local_34: u32;
var phi_2174_: f32;
var phi_2177_: u32;
var phi_2175_: f32;
var phi_2178_: u32;
var phi_2189_: u32;
var phi_2200_: u32;
var phi_2243_: i32;
var phi_2337_: i32;
var phi_2438_: u32;
var phi_2439_: u32;
var phi_2440_: u32;
var phi_3138_: u32;
var phi_3139_: u32;
var phi_3140_: u32;
var phi_3207_: u32;
var phi_3261_: u32;
var phi_3325_: u32;
var phi_3379_: u32;
var phi_3443_: u32;
var phi_3497_: u32;
var phi_3540_: bool;
var phi_3546_: bool;
var phi_3568_: i32;
var phi_3614_: type_5;
var phi_3617_: i32;
var phi_3666_: i32;
var phi_3667_: i32;
var phi_3743_: i32;
var phi_3754_: i32;
var phi_3828_: u32;
var phi_3829_: u32;
var phi_3830_: u32;
var phi_4223_: u32;
var phi_4247_: i32;
var phi_4258_: i32;
var phi_4332_: u32;
var phi_4333_: u32;
var phi_4334_: u32;
var phi_4727_: u32;
var phi_4751_: i32;
var phi_4762_: i32;
var phi_4836_: u32;
var phi_4837_: u32;
var phi_4838_: u32;
var phi_5231_: u32;
var phi_5255_: i32;
var phi_5266_: i32;
var phi_5340_: u32;
var phi_5341_: u32;
var phi_5342_: u32;
var phi_5735_: u32;
var phi_5746_: f32;
var phi_5782_: i32;
var phi_5783_: i32;
var phi_5859_: i32;
var phi_5870_: i32;
var phi_5944_: u32;
var phi_5945_: u32;
var phi_5946_: u32;
var phi_6339_: u32;
var phi_6363_: i32;
var phi_6374_: i32;
var phi_6448_: u32;
var phi_6449_: u32;
var phi_6450_: u32;
var phi_6843_: u32;
var phi_6867_: i32;
var phi_6878_: i32;
var phi_6952_: u32;
var phi_6953_: u32;
var phi_6954_: u32;
var phi_7347_: u32;
var phi_7371_: i32;
var phi_7382_: i32;
var phi_7456_: u32;
var phi_7457_: u32;
var phi_7458_: u32;
var phi_7851_: u32;
var phi_7862_: f32;
var phi_7900_: i32;
var phi_7901_: i32;
var phi_7977_: i32;
var phi_7988_: i32;
var phi_8062_: u32;
var phi_8063_: u32;
var phi_8064_: u32;
var phi_8457_: u32;
var phi_8481_: i32;
var phi_8492_: i32;
var phi_8566_: u32;
var phi_8567_: u32;
var phi_8568_: u32;
var phi_8961_: u32;
var phi_8985_: i32;
var phi_8996_: i32;
var phi_9070_: u32;
var phi_9071_: u32;
var phi_9072_: u32;
var phi_9465_: u32;
var phi_9489_: i32;
var phi_9500_: i32;
var phi_9574_: u32;
var phi_9575_: u32;
var phi_9576_: u32;
var phi_9969_: u32;
var phi_9980_: f32;
var phi_9981_: f32;
var phi_10709_: u32;
var phi_10763_: u32;
var phi_10827_: u32;
var phi_10881_: u32;
var phi_10945_: u32;
var phi_10999_: u32;
var phi_3618_: i32;
var phi_3569_: i32;
var phi_2338_: i32;
var phi_2244_: i32;
var local_35: u32;
var local_36: u32;
var local_37: u32;
var local_38: u32;
var local_39: u32;
var local_40: u32;
let _e101 = global;
let _e111 = arrayLength((&global_4.member));
let _e113 = arrayLength((&global_5.member));
let _e116 = global_1.member.member;
if (_e101.x < _e116.member) {
if (_e101.y < _e116.member_1) {
let _e126 = global_1.member.member.member_1;
let _e127 = bitcast<i32>(_e126);
let _e131 = global_1.member.member_12.member_4;
let _e135 = global_1.member.member_12.member_5;
let _e137 = bitcast<i32>((_e131 * _e135));
let _e138 = bitcast<i32>(_e101.y);
local_29 = _e137;
local_30 = _e138;
local_31 = _e127;
let _e139 = local_29;
let _e140 = local_31;
let _e143 = local_30;
let _e144 = ((_e139 + (18i * _e140)) + _e143);
let _e146 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e148 = select(_e146, _e144, (_e144 < _e146));
let _e153 = global_2.member[bitcast<u32>(select(0i, _e148, (_e148 > 0i)))];
let _e154 = local_29;
let _e155 = local_31;
let _e158 = local_30;
let _e159 = ((_e154 + (19i * _e155)) + _e158);
let _e161 = select(_e146, _e159, (_e159 < _e146));
let _e166 = global_2.member[bitcast<u32>(select(0i, _e161, (_e161 > 0i)))];
let _e168 = local_29;
let _e169 = local_31;
let _e172 = local_30;
let _e173 = ((_e168 + (20i * _e169)) + _e172);
let _e175 = select(_e146, _e173, (_e173 < _e146));
let _e180 = global_2.member[bitcast<u32>(select(0i, _e175, (_e175 > 0i)))];
if (((_e153 + _e166) + _e180) > 0f) {
local_26 = _e137;
local_27 = _e138;
local_28 = _e127;
let _e183 = local_26;
let _e184 = local_27;
let _e185 = (_e183 + _e184);
let _e187 = select(_e146, _e185, (_e185 < _e146));
let _e192 = global_2.member[bitcast<u32>(select(0i, _e187, (_e187 > 0i)))];
let _e193 = local_26;
let _e194 = local_28;
let _e196 = local_27;
let _e197 = ((_e193 + _e194) + _e196);
let _e199 = select(_e146, _e197, (_e197 < _e146));
let _e204 = global_2.member[bitcast<u32>(select(0i, _e199, (_e199 > 0i)))];
let _e205 = local_26;
let _e206 = local_28;
let _e209 = local_27;
let _e210 = ((_e205 + (2i * _e206)) + _e209);
let _e212 = select(_e146, _e210, (_e210 < _e146));
let _e217 = global_2.member[bitcast<u32>(select(0i, _e212, (_e212 > 0i)))];
let _e218 = local_26;
let _e219 = local_28;
let _e222 = local_27;
let _e223 = ((_e218 + (3i * _e219)) + _e222);
let _e225 = select(_e146, _e223, (_e223 < _e146));
let _e230 = global_2.member[bitcast<u32>(select(0i, _e225, (_e225 > 0i)))];
let _e231 = local_26;
let _e232 = local_28;
let _e235 = local_27;
let _e236 = ((_e231 + (4i * _e232)) + _e235);
let _e238 = select(_e146, _e236, (_e236 < _e146));
let _e243 = global_2.member[bitcast<u32>(select(0i, _e238, (_e238 > 0i)))];
let _e244 = local_26;
let _e245 = local_28;
let _e248 = local_27;
let _e249 = ((_e244 + (5i * _e245)) + _e248);
let _e251 = select(_e146, _e249, (_e249 < _e146));
let _e256 = global_2.member[bitcast<u32>(select(0i, _e251, (_e251 > 0i)))];
let _e257 = local_26;
let _e258 = local_28;
let _e261 = local_27;
let _e262 = ((_e257 + (6i * _e258)) + _e261);
let _e264 = select(_e146, _e262, (_e262 < _e146));
let _e269 = global_2.member[bitcast<u32>(select(0i, _e264, (_e264 > 0i)))];
let _e270 = local_26;
let _e271 = local_28;
let _e274 = local_27;
let _e275 = ((_e270 + (7i * _e271)) + _e274);
let _e277 = select(_e146, _e275, (_e275 < _e146));
let _e282 = global_2.member[bitcast<u32>(select(0i, _e277, (_e277 > 0i)))];
let _e283 = local_26;
let _e284 = local_28;
let _e287 = local_27;
let _e288 = ((_e283 + (8i * _e284)) + _e287);
let _e290 = select(_e146, _e288, (_e288 < _e146));
let _e295 = global_2.member[bitcast<u32>(select(0i, _e290, (_e290 > 0i)))];
let _e296 = local_26;
let _e297 = local_28;
let _e300 = local_27;
let _e301 = ((_e296 + (9i * _e297)) + _e300);
let _e303 = select(_e146, _e301, (_e301 < _e146));
let _e308 = global_2.member[bitcast<u32>(select(0i, _e303, (_e303 > 0i)))];
let _e309 = local_26;
let _e310 = local_28;
let _e313 = local_27;
let _e314 = ((_e309 + (10i * _e310)) + _e313);
let _e316 = select(_e146, _e314, (_e314 < _e146));
let _e321 = global_2.member[bitcast<u32>(select(0i, _e316, (_e316 > 0i)))];
let _e322 = local_26;
let _e323 = local_28;
let _e326 = local_27;
let _e327 = ((_e322 + (11i * _e323)) + _e326);
let _e329 = select(_e146, _e327, (_e327 < _e146));
let _e334 = global_2.member[bitcast<u32>(select(0i, _e329, (_e329 > 0i)))];
let _e335 = local_26;
let _e336 = local_28;
let _e339 = local_27;
let _e340 = ((_e335 + (12i * _e336)) + _e339);
let _e342 = select(_e146, _e340, (_e340 < _e146));
let _e347 = global_2.member[bitcast<u32>(select(0i, _e342, (_e342 > 0i)))];
let _e348 = local_26;
let _e349 = local_28;
let _e352 = local_27;
let _e353 = ((_e348 + (13i * _e349)) + _e352);
let _e355 = select(_e146, _e353, (_e353 < _e146));
let _e360 = global_2.member[bitcast<u32>(select(0i, _e355, (_e355 > 0i)))];
let _e361 = local_26;
let _e362 = local_28;
let _e365 = local_27;
let _e366 = ((_e361 + (14i * _e362)) + _e365);
let _e368 = select(_e146, _e366, (_e366 < _e146));
let _e373 = global_2.member[bitcast<u32>(select(0i, _e368, (_e368 > 0i)))];
let _e374 = local_26;
let _e375 = local_28;
let _e378 = local_27;
let _e379 = ((_e374 + (15i * _e375)) + _e378);
let _e381 = select(_e146, _e379, (_e379 < _e146));
let _e386 = global_2.member[bitcast<u32>(select(0i, _e381, (_e381 > 0i)))];
let _e387 = local_26;
let _e388 = local_28;
let _e391 = local_27;
let _e392 = ((_e387 + (16i * _e388)) + _e391);
let _e394 = select(_e146, _e392, (_e392 < _e146));
let _e399 = global_2.member[bitcast<u32>(select(0i, _e394, (_e394 > 0i)))];
let _e400 = local_26;
let _e401 = local_28;
let _e404 = local_27;
let _e405 = ((_e400 + (17i * _e401)) + _e404);
let _e407 = select(_e146, _e405, (_e405 < _e146));
let _e412 = global_2.member[bitcast<u32>(select(0i, _e407, (_e407 > 0i)))];
let _e413 = local_26;
let _e414 = local_28;
let _e417 = local_27;
let _e418 = ((_e413 + (18i * _e414)) + _e417);
let _e420 = select(_e146, _e418, (_e418 < _e146));
let _e425 = global_2.member[bitcast<u32>(select(0i, _e420, (_e420 > 0i)))];
let _e426 = local_26;
let _e427 = local_28;
let _e430 = local_27;
let _e431 = ((_e426 + (19i * _e427)) + _e430);
let _e433 = select(_e146, _e431, (_e431 < _e146));
let _e438 = global_2.member[bitcast<u32>(select(0i, _e433, (_e433 > 0i)))];
let _e439 = local_26;
let _e440 = local_28;
let _e443 = local_27;
let _e444 = ((_e439 + (20i * _e440)) + _e443);
let _e446 = select(_e146, _e444, (_e444 < _e146));
let _e451 = global_2.member[bitcast<u32>(select(0i, _e446, (_e446 > 0i)))];
let _e452 = local_26;
let _e453 = local_28;
let _e456 = local_27;
let _e457 = ((_e452 + (23i * _e453)) + _e456);
let _e459 = select(_e146, _e457, (_e457 < _e146));
let _e464 = global_2.member[bitcast<u32>(select(0i, _e459, (_e459 > 0i)))];
let _e467 = global_1.member.member_6;
let _e471 = (_e192 - _e467.member);
let _e472 = (_e204 - _e467.member_1);
let _e473 = (_e217 - _e467.member_2);
let _e476 = ((_e472 * _e256) - (_e473 * _e243));
let _e479 = ((_e473 * _e230) - (_e471 * _e256));
let _e482 = ((_e471 * _e243) - (_e472 * _e230));
let _e485 = global_1.member.member_3;
let _e491 = global_1.member.member_4;
let _e497 = global_1.member.member_5;
let _e504 = global_1.member.member_2.member_3;
let _e505 = (_e504 != 0u);
let _e508 = ((_e497.member_1 * _e485.member_2) - (_e497.member_2 * _e485.member_1));
let _e511 = ((_e497.member_2 * _e485.member) - (_e497.member * _e485.member_2));
let _e514 = ((_e497.member * _e485.member_1) - (_e497.member_1 * _e485.member));
let _e526 = select((((_e485.member * _e476) + (_e485.member_1 * _e479)) + (_e485.member_2 * _e482)), -((((_e508 * _e230) + (_e511 * _e243)) + (_e514 * _e256))), _e505);
let _e529 = ((_e497.member_1 * _e491.member_2) - (_e497.member_2 * _e491.member_1));
let _e532 = ((_e497.member_2 * _e491.member) - (_e497.member * _e491.member_2));
let _e535 = ((_e497.member * _e491.member_1) - (_e497.member_1 * _e491.member));
let _e547 = select((((_e491.member * _e476) + (_e491.member_1 * _e479)) + (_e491.member_2 * _e482)), -((((_e529 * _e230) + (_e532 * _e243)) + (_e535 * _e256))), _e505);
let _e556 = global_1.member.member_1.member;
let _e558 = f32(bitcast<i32>(_e556));
let _e562 = global_1.member.member_1.member_1;
let _e564 = f32(bitcast<i32>(_e562));
let _e568 = global_1.member.member_2.member;
let _e572 = global_1.member.member_2.member_1;
let _e574 = ((2f * _e568) / _e558);
let _e575 = (_e526 * _e574);
let _e577 = ((-2f * _e572) / _e564);
let _e578 = (_e547 * _e577);
let _e580 = ((_e568 / _e558) - _e568);
let _e584 = (_e572 - (_e572 / _e564));
let _e586 = (((((_e497.member * _e476) + (_e497.member_1 * _e479)) + (_e497.member_2 * _e482)) + (_e526 * _e580)) + (_e547 * _e584));
let _e605 = (((_e282 * _e256) - (_e295 * _e243)) + ((_e472 * _e373) - (_e473 * _e360)));
let _e606 = (((_e295 * _e230) - (_e269 * _e256)) + ((_e473 * _e347) - (_e471 * _e373)));
let _e607 = (((_e269 * _e243) - (_e282 * _e230)) + ((_e471 * _e360) - (_e472 * _e347)));
let _e619 = select((((_e485.member * _e605) + (_e485.member_1 * _e606)) + (_e485.member_2 * _e607)), -((((_e508 * _e347) + (_e511 * _e360)) + (_e514 * _e373))), _e505);
let _e631 = select((((_e491.member * _e605) + (_e491.member_1 * _e606)) + (_e491.member_2 * _e607)), -((((_e529 * _e347) + (_e532 * _e360)) + (_e535 * _e373))), _e505);
let _e637 = (_e619 * _e574);
let _e638 = (_e631 * _e577);
let _e642 = (((((_e497.member * _e605) + (_e497.member_1 * _e606)) + (_e497.member_2 * _e607)) + (_e619 * _e580)) + (_e631 * _e584));
let _e661 = (((_e321 * _e256) - (_e334 * _e243)) + ((_e472 * _e412) - (_e473 * _e399)));
let _e662 = (((_e334 * _e230) - (_e308 * _e256)) + ((_e473 * _e386) - (_e471 * _e412)));
let _e663 = (((_e308 * _e243) - (_e321 * _e230)) + ((_e471 * _e399) - (_e472 * _e386)));
let _e675 = select((((_e485.member * _e661) + (_e485.member_1 * _e662)) + (_e485.member_2 * _e663)), -((((_e508 * _e386) + (_e511 * _e399)) + (_e514 * _e412))), _e505);
let _e687 = select((((_e491.member * _e661) + (_e491.member_1 * _e662)) + (_e491.member_2 * _e663)), -((((_e529 * _e386) + (_e532 * _e399)) + (_e535 * _e412))), _e505);
let _e693 = (_e675 * _e574);
let _e694 = (_e687 * _e577);
let _e698 = (((((_e497.member * _e661) + (_e497.member_1 * _e662)) + (_e497.member_2 * _e663)) + (_e675 * _e580)) + (_e687 * _e584));
let _e705 = (bitcast<f32>((bitcast<u32>(_e575) & 2147483647u)) > bitcast<f32>((bitcast<u32>(_e578) & 2147483647u)));
let _e706 = select(_e575, _e578, _e705);
let _e707 = select(_e578, _e575, _e705);
let _e708 = select(_e637, _e638, _e705);
let _e709 = select(_e638, _e637, _e705);
let _e710 = select(_e693, _e694, _e705);
let _e711 = select(_e694, _e693, _e705);
let _e714 = bitcast<f32>((bitcast<u32>(_e707) & 2147483647u));
let _e720 = ((((_e497.member * _e471) + (_e497.member_1 * _e472)) + (_e497.member_2 * _e473)) - 1e-3f);
let _e725 = (((_e497.member * _e230) + (_e497.member_1 * _e243)) + (_e497.member_2 * _e256));
if (_e504 == 0u) {
let _e728 = (_e725 == 0f);
let _e730 = (-(_e720) / select(_e725, 1e-30f, _e728));
phi_1532_ = type_23(select(0f, select(0f, _e730, (_e730 > 0f)), (_e725 > 0f)), select(select(_e464, select(_e464, _e730, (_e730 < _e464)), (_e725 < 0f)), -1f, (_e728 && (_e720 < 0f))));
} else {
phi_1532_ = type_23(0f, _e464);
}
let _e745 = phi_1532_;
if ((_e714 <= 0f) || (_e745.member_1 <= _e745.member)) {
} else {
let _e757 = ((_e192 + (_e230 * _e745.member)) - _e467.member);
let _e758 = ((_e204 + (_e243 * _e745.member)) - _e467.member_1);
let _e759 = ((_e217 + (_e256 * _e745.member)) - _e467.member_2);
let _e764 = (((_e497.member * _e757) + (_e497.member_1 * _e758)) + (_e497.member_2 * _e759));
let _e768 = select((1f / select(1e-3f, _e764, (_e764 > 1e-3f))), 1f, _e505);
let _e777 = (0.5f * _e558);
let _e779 = ((((((((_e485.member * _e757) + (_e485.member_1 * _e758)) + (_e485.member_2 * _e759)) * _e768) / _e568) + 1f) * _e777) - 0.5f);
let _e788 = (0.5f * _e564);
let _e790 = (((1f - (((((_e491.member * _e757) + (_e491.member_1 * _e758)) + (_e491.member_2 * _e759)) * _e768) / _e572)) * _e788) - 0.5f);
let _e791 = -(1e6f);
let _e793 = select(_e791, _e779, (_e779 > _e791));
let _e795 = select(1e6f, _e793, (_e793 < 1e6f));
let _e797 = select(_e791, _e790, (_e790 > _e791));
let _e799 = select(1e6f, _e797, (_e797 < 1e6f));
let _e800 = select(_e795, _e799, _e705);
let _e801 = select(_e799, _e795, _e705);
let _e819 = (bitcast<f32>((bitcast<u32>(_e706) & 2147483647u)) / _e714);
let _e823 = (0.5f * 1f);
let _e825 = ((((0.5f * (bitcast<f32>((bitcast<u32>(((_e708 * _e800) + ((_e709 * _e801) + _e642))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e710 * _e800) + ((_e711 * _e801) + _e698))) & 2147483647u)))) / _e714) + _e823) * _e819);
let _e828 = (select(1e6f, _e825, (_e825 < 1e6f)) + 1f);
let _e835 = ((_e192 + (_e230 * _e745.member_1)) - _e467.member);
let _e836 = ((_e204 + (_e243 * _e745.member_1)) - _e467.member_1);
let _e837 = ((_e217 + (_e256 * _e745.member_1)) - _e467.member_2);
let _e842 = (((_e497.member * _e835) + (_e497.member_1 * _e836)) + (_e497.member_2 * _e837));
let _e846 = select((1f / select(1e-3f, _e842, (_e842 > 1e-3f))), 1f, _e505);
let _e856 = ((((((((_e485.member * _e835) + (_e485.member_1 * _e836)) + (_e485.member_2 * _e837)) * _e846) / _e568) + 1f) * _e777) - 0.5f);
let _e866 = (((1f - (((((_e491.member * _e835) + (_e491.member_1 * _e836)) + (_e491.member_2 * _e837)) * _e846) / _e572)) * _e788) - 0.5f);
let _e868 = select(_e791, _e856, (_e856 > _e791));
let _e870 = select(1e6f, _e868, (_e868 < 1e6f));
let _e872 = select(_e791, _e866, (_e866 > _e791));
let _e874 = select(1e6f, _e872, (_e872 < 1e6f));
let _e875 = select(_e870, _e874, _e705);
let _e876 = select(_e874, _e870, _e705);
let _e895 = ((((0.5f * (bitcast<f32>((bitcast<u32>(((_e708 * _e875) + ((_e709 * _e876) + _e642))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e710 * _e875) + ((_e711 * _e876) + _e698))) & 2147483647u)))) / _e714) + _e823) * _e819);
let _e898 = (select(1e6f, _e895, (_e895 < 1e6f)) + 1f);
let _e900 = bitcast<i32>(select(_e556, _e562, _e705));
let _e904 = bitcast<i32>((_e101.x * 16u));
let _e905 = (_e904 + 16i);
let _e906 = (_e875 < _e800);
let _e907 = (_e800 - _e828);
let _e908 = (_e875 - _e898);
let _e910 = select(_e908, _e907, (_e907 < _e908));
let _e911 = (_e800 + _e828);
let _e912 = (_e875 + _e898);
let _e914 = select(_e912, _e911, (_e911 > _e912));
let _e915 = select(_e911, _e912, _e906);
let _e916 = select(_e908, _e907, _e906);
let _e917 = f32(_e904);
let _e919 = (_e904 + 15i);
let _e922 = ((_e914 < _e917) || (_e910 > f32(_e919)));
if _e922 {
} else {
let _e924 = (0.5f * (16f - 1f));
let _e925 = (_e917 + _e924);
let _e929 = (-(((_e706 * _e925) + _e586)) / _e707);
let _e948 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e708 * _e925) + ((_e709 * _e929) + _e642))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e710 * _e925) + ((_e711 * _e929) + _e698))) & 2147483647u)))) / _e714) + _e823));
let _e952 = global_1.member.member_18.member_1;
phi_1942_ = 8f;
phi_1945_ = 0u;
loop {
let _e954 = phi_1942_;
let _e956 = phi_1945_;
local_32 = _e956;
local_35 = _e956;
let _e959 = ((_e956 < _e952) && (_e948 >= _e954));
if _e959 {
phi_1943_ = (_e954 * 2f);
phi_1946_ = (_e956 + 1u);
} else {
phi_1943_ = f32();
phi_1946_ = u32();
}
let _e963 = phi_1943_;
let _e965 = phi_1946_;
continue;
continuing {
phi_1942_ = _e963;
phi_1945_ = _e965;
break if !(_e959);
}
}
let _e968 = local_32;
let _e972 = f32((1i << bitcast<u32>((_e968 & 31u))));
let _e975 = f32(_e905);
if (((_e917 - _e972) > _e915) && ((_e975 + _e972) < _e916)) {
let _e4943 = local_35;
phi_1990_ = _e4943;
} else {
phi_1975_ = 8f;
phi_1978_ = 0u;
loop {
let _e981 = phi_1975_;
let _e983 = phi_1978_;
local_36 = _e983;
let _e986 = ((_e983 < _e952) && ((_e948 * 0.125f) >= _e981));
if _e986 {
phi_1976_ = (_e981 * 2f);
phi_1979_ = (_e983 + 1u);
} else {
phi_1976_ = f32();
phi_1979_ = u32();
}
let _e990 = phi_1976_;
let _e992 = phi_1979_;
continue;
continuing {
phi_1975_ = _e990;
phi_1978_ = _e992;
break if !(_e986);
}
}
let _e4945 = local_36;
phi_1990_ = _e4945;
}
let _e995 = phi_1990_;
let _e996 = select(_e995, 0u, _e922);
if (_e904 > 0i) {
let _e999 = f32((_e904 - 16i));
let _e1000 = (_e999 + _e924);
let _e1004 = (-(((_e706 * _e1000) + _e586)) / _e707);
let _e1023 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e708 * _e1000) + ((_e709 * _e1004) + _e642))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e710 * _e1000) + ((_e711 * _e1004) + _e698))) & 2147483647u)))) / _e714) + _e823));
phi_2042_ = 8f;
phi_2045_ = 0u;
loop {
let _e1025 = phi_2042_;
let _e1027 = phi_2045_;
local_33 = _e1027;
local_37 = _e1027;
let _e1030 = ((_e1027 < _e952) && (_e1023 >= _e1025));
if _e1030 {
phi_2043_ = (_e1025 * 2f);
phi_2046_ = (_e1027 + 1u);
} else {
phi_2043_ = f32();
phi_2046_ = u32();
}
let _e1034 = phi_2043_;
let _e1036 = phi_2046_;
continue;
continuing {
phi_2042_ = _e1034;
phi_2045_ = _e1036;
break if !(_e1030);
}
}
let _e1039 = local_33;
let _e1043 = f32((1i << bitcast<u32>((_e1039 & 31u))));
if (((_e999 - _e1043) > _e915) && ((_e917 + _e1043) < _e916)) {
let _e4957 = local_37;
phi_2090_ = _e4957;
} else {
phi_2075_ = 8f;
phi_2078_ = 0u;
loop {
let _e1051 = phi_2075_;
let _e1053 = phi_2078_;
local_38 = _e1053;
let _e1056 = ((_e1053 < _e952) && ((_e1023 * 0.125f) >= _e1051));
if _e1056 {
phi_2076_ = (_e1051 * 2f);
phi_2079_ = (_e1053 + 1u);
} else {
phi_2076_ = f32();
phi_2079_ = u32();
}
let _e1060 = phi_2076_;
let _e1062 = phi_2079_;
continue;
continuing {
phi_2075_ = _e1060;
phi_2078_ = _e1062;
break if !(_e1056);
}
}
let _e4959 = local_38;
phi_2090_ = _e4959;
}
let _e1065 = phi_2090_;
phi_2101_ = select(_e1065, _e996, ((_e914 < _e999) || (_e910 > f32((_e904 - 1i)))));
} else {
phi_2101_ = _e996;
}
let _e1073 = phi_2101_;
let _e1074 = (_e905 < _e900);
if _e1074 {
let _e1076 = (_e975 + _e924);
let _e1080 = (-(((_e706 * _e1076) + _e586)) / _e707);
let _e1099 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e708 * _e1076) + ((_e709 * _e1080) + _e642))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e710 * _e1076) + ((_e711 * _e1080) + _e698))) & 2147483647u)))) / _e714) + _e823));
phi_2141_ = 8f;
phi_2144_ = 0u;
loop {
let _e1101 = phi_2141_;
let _e1103 = phi_2144_;
local_34 = _e1103;
local_39 = _e1103;
let _e1106 = ((_e1103 < _e952) && (_e1099 >= _e1101));
if _e1106 {
phi_2142_ = (_e1101 * 2f);
phi_2145_ = (_e1103 + 1u);
} else {
phi_2142_ = f32();
phi_2145_ = u32();
}
let _e1110 = phi_2142_;
let _e1112 = phi_2145_;
continue;
continuing {
phi_2141_ = _e1110;
phi_2144_ = _e1112;
break if !(_e1106);
}
}
let _e1115 = local_34;
let _e1119 = f32((1i << bitcast<u32>((_e1115 & 31u))));
if (((_e975 - _e1119) > _e915) && ((f32((_e904 + 32i)) + _e1119) < _e916)) {
let _e4972 = local_39;
phi_2189_ = _e4972;
} else {
phi_2174_ = 8f;
phi_2177_ = 0u;
loop {
let _e1128 = phi_2174_;
let _e1130 = phi_2177_;
local_40 = _e1130;
let _e1133 = ((_e1130 < _e952) && ((_e1099 * 0.125f) >= _e1128));
if _e1133 {
phi_2175_ = (_e1128 * 2f);
phi_2178_ = (_e1130 + 1u);
} else {
phi_2175_ = f32();
phi_2178_ = u32();
}
let _e1137 = phi_2175_;
let _e1139 = phi_2178_;
continue;
continuing {
phi_2174_ = _e1137;
phi_2177_ = _e1139;
break if !(_e1133);
}
}
let _e4974 = local_40;
phi_2189_ = _e4974;
}
let _e1142 = phi_2189_;
phi_2200_ = select(_e1142, _e996, ((_e914 < _e975) || (_e910 > f32((_e904 + 31i)))));
} else {
phi_2200_ = _e996;
}
let _e1150 = phi_2200_;
let _e1151 = (_e996 & 31u);
let _e1153 = (1i << bitcast<u32>(_e1151));
let _e1154 = f32(_e1153);
let _e1156 = select(_e917, _e910, (_e910 > _e917));
let _e1173 = f32(((bitcast<i32>(select(_e562, _e556, _e705)) - 1i) >> bitcast<u32>(_e1151)));
phi_2243_ = (select(0i, select(select(i32(_e1156), i32(-2147483648), (_e1156 < -2147483600f)), 2147483647i, (_e1156 > 2147483500f)), (_e1156 == _e1156)) >> bitcast<u32>(_e1151));
loop {
let _e1175 = phi_2243_;
let _e1176 = (_e1175 <= ((select(_e900, _e905, _e1074) - 1i) >> bitcast<u32>(_e1151)));
if _e1176 {
let _e1180 = (((f32(_e1175) + 0.5f) * _e1154) - 0.5f);
let _e1184 = (-(((_e706 * _e1180) + _e586)) / _e707);
let _e1191 = bitcast<f32>((bitcast<u32>(((_e708 * _e1180) + ((_e709 * _e1184) + _e642))) & 2147483647u));
let _e1198 = bitcast<f32>((bitcast<u32>(((_e710 * _e1180) + ((_e711 * _e1184) + _e698))) & 2147483647u));
let _e1204 = (((0.5f * (_e1191 + _e1198)) / _e714) + (0.5f * _e1154));
let _e1212 = ((((_e1184 + _e1204) + 0.5f) / _e1154) - 0.5f);
let _e1213 = (((((_e1184 - _e1204) + 0.5f) / _e1154) - 0.5f) + 1f);
let _e1214 = (_e1173 + 1f);
let _e1216 = select(0f, _e1213, (_e1213 > 0f));
let _e1218 = select(_e1214, _e1216, (_e1216 < _e1214));
let _e1225 = select(0i, select(select(i32(_e1218), i32(-2147483648), (_e1218 < -2147483600f)), 2147483647i, (_e1218 > 2147483500f)), (_e1218 == _e1218));
let _e1231 = select(-1f, _e1212, (_e1212 > -1f));
let _e1233 = select(_e1173, _e1231, (_e1231 < _e1173));
let _e1240 = select(0i, select(select(i32(_e1233), i32(-2147483648), (_e1233 < -2147483600f)), 2147483647i, (_e1233 > 2147483500f)), (_e1233 == _e1233));
phi_2337_ = (_e1225 - select(0i, 1i, (_e1218 < f32(_e1225))));
loop {
let _e1246 = phi_2337_;
let _e1247 = (_e1246 <= (_e1240 - select(0i, 1i, (_e1233 < f32(_e1240)))));
if _e1247 {
let _e1265 = (_e996 > 0u);
if _e1265 {
let _e1269 = (((f32(_e1246) + 0.5f) * _e1154) - 0.5f);
let _e1272 = select(_e1175, _e1246, _e705);
let _e1273 = select(_e1246, _e1175, _e705);
let _e1276 = global_1.member.member_1.member;
let _e1280 = bitcast<i32>(((_e1276 + 1u) >> bitcast<u32>(1u)));
let _e1283 = global_1.member.member_18.member_9;
let _e1288 = global_1.member.member_18.member_6;
let _e1291 = global_1.member.member_18.member_7;
let _e1294 = global_1.member.member_18.member_8;
let _e1295 = (_e996 == 0u);
if _e1295 {
phi_2440_ = 0u;
} else {
if (_e996 == 1u) {
phi_2439_ = 0u;
} else {
if (_e996 == 2u) {
phi_2438_ = _e1288;
} else {
phi_2438_ = select(_e1294, _e1291, (_e996 == 3u));
}
let _e1301 = phi_2438_;
phi_2439_ = _e1301;
}
let _e1303 = phi_2439_;
phi_2440_ = _e1303;
}
let _e1305 = phi_2440_;
local_24 = (((bitcast<i32>(_e1305) + _e1273) * _e1280) + _e1272);
local_25 = (_e1280 * bitcast<i32>(_e1283));
let _e1310 = local_24;
let _e1312 = (bitcast<i32>(_e111) - 1i);
let _e1314 = select(_e1312, _e1310, (_e1310 < _e1312));
let _e1319 = global_4.member[bitcast<u32>(select(0i, _e1314, (_e1314 > 0i)))];
let _e1320 = local_25;
let _e1321 = local_24;
let _e1322 = (_e1320 + _e1321);
let _e1324 = select(_e1312, _e1322, (_e1322 < _e1312));
let _e1329 = global_4.member[bitcast<u32>(select(0i, _e1324, (_e1324 > 0i)))];
let _e1330 = local_25;
let _e1332 = local_24;
let _e1333 = ((2i * _e1330) + _e1332);
let _e1335 = select(_e1312, _e1333, (_e1333 < _e1312));
let _e1340 = global_4.member[bitcast<u32>(select(0i, _e1335, (_e1335 > 0i)))];
let _e1341 = local_25;
let _e1343 = local_24;
let _e1344 = ((3i * _e1341) + _e1343);
let _e1346 = select(_e1312, _e1344, (_e1344 < _e1312));
let _e1351 = global_4.member[bitcast<u32>(select(0i, _e1346, (_e1346 > 0i)))];
let _e1356 = global_1.member.member_1.member_1;
let _e1365 = global_1.member.member_2.member;
let _e1366 = (((((select(_e1180, _e1269, _e705) + 0.5f) / f32(bitcast<i32>(_e1276))) * 2f) - 1f) * _e1365);
let _e1373 = global_1.member.member_2.member_1;
let _e1374 = ((1f - (((select(_e1269, _e1180, _e705) + 0.5f) / f32(bitcast<i32>(_e1356))) * 2f)) * _e1373);
let _e1376 = global_1.member.member_3;
let _e1384 = global_1.member.member_4;
let _e1391 = ((_e1376.member * _e1366) + (_e1384.member * _e1374));
let _e1392 = ((_e1376.member_1 * _e1366) + (_e1384.member_1 * _e1374));
let _e1393 = ((_e1376.member_2 * _e1366) + (_e1384.member_2 * _e1374));
let _e1396 = global_1.member.member_2.member_3;
let _e1397 = (_e1396 != 0u);
let _e1399 = global_1.member.member_5;
let _e1406 = select((_e1399.member + _e1391), _e1399.member, _e1397);
let _e1407 = select((_e1399.member_1 + _e1392), _e1399.member_1, _e1397);
let _e1408 = select((_e1399.member_2 + _e1393), _e1399.member_2, _e1397);
let _e1410 = global_1.member.member_6;
let _e1424 = (((_e1406 * _e1406) + (_e1407 * _e1407)) + (_e1408 * _e1408));
let _e1427 = sqrt(select(0f, _e1424, (_e1424 > 0f)));
let _e1428 = (1f / _e1427);
let _e1429 = (_e1406 * _e1428);
let _e1430 = (_e1407 * _e1428);
let _e1431 = (_e1408 * _e1428);
let _e1432 = (_e192 - select(_e1410.member, (_e1410.member + _e1391), _e1397));
let _e1433 = (_e204 - select(_e1410.member_1, (_e1410.member_1 + _e1392), _e1397));
let _e1434 = (_e217 - select(_e1410.member_2, (_e1410.member_2 + _e1393), _e1397));
let _e1439 = (((_e1432 * _e1429) + (_e1433 * _e1430)) + (_e1434 * _e1431));
let _e1444 = (((_e1432 * _e230) + (_e1433 * _e243)) + (_e1434 * _e256));
let _e1449 = (((_e1429 * _e230) + (_e1430 * _e243)) + (_e1431 * _e256));
let _e1452 = ((_e1430 * _e256) - (_e1431 * _e243));
let _e1455 = ((_e1431 * _e230) - (_e1429 * _e256));
let _e1458 = ((_e1429 * _e243) - (_e1430 * _e230));
let _e1463 = (((_e1452 * _e1452) + (_e1455 * _e1455)) + (_e1458 * _e1458));
let _e1466 = (1f / select(1e-9f, _e1463, (_e1463 > 1e-9f)));
let _e1469 = ((_e1439 - (_e1449 * _e1444)) * _e1466);
let _e1472 = (((_e1449 * _e1439) - _e1444) * _e1466);
let _e1478 = (_e1469 - _e1351);
let _e1481 = (_e1472 + select(0f, _e1478, (_e1478 > 0f)));
let _e1484 = global_1.member.member_13.member;
let _e1489 = -((_e1484.member * _e1481));
let _e1491 = select(-87f, _e1489, (_e1489 > -87f));
let _e1493 = select(88f, _e1491, (_e1491 < 88f));
let _e1495 = ((_e1493 * 1.442695f) + 0.5f);
let _e1497 = select(-127f, _e1495, (_e1495 > -127f));
let _e1499 = select(128f, _e1497, (_e1497 < 128f));
let _e1506 = select(0i, select(select(i32(_e1499), i32(-2147483648), (_e1499 < -2147483600f)), 2147483647i, (_e1499 > 2147483500f)), (_e1499 == _e1499));
let _e1510 = (_e1506 - select(0i, 1i, (_e1499 < f32(_e1506))));
let _e1511 = f32(_e1510);
let _e1515 = ((_e1493 - (_e1511 * 0.6933594f)) - (_e1511 * -2.1219444e-4f));
let _e1537 = -((_e1484.member_1 * _e1481));
let _e1539 = select(-87f, _e1537, (_e1537 > -87f));
let _e1541 = select(88f, _e1539, (_e1539 < 88f));
let _e1543 = ((_e1541 * 1.442695f) + 0.5f);
let _e1545 = select(-127f, _e1543, (_e1543 > -127f));
let _e1547 = select(128f, _e1545, (_e1545 < 128f));
let _e1554 = select(0i, select(select(i32(_e1547), i32(-2147483648), (_e1547 < -2147483600f)), 2147483647i, (_e1547 > 2147483500f)), (_e1547 == _e1547));
let _e1558 = (_e1554 - select(0i, 1i, (_e1547 < f32(_e1554))));
let _e1559 = f32(_e1558);
let _e1563 = ((_e1541 - (_e1559 * 0.6933594f)) - (_e1559 * -2.1219444e-4f));
let _e1585 = -((_e1484.member_2 * _e1481));
let _e1587 = select(-87f, _e1585, (_e1585 > -87f));
let _e1589 = select(88f, _e1587, (_e1587 < 88f));
let _e1591 = ((_e1589 * 1.442695f) + 0.5f);
let _e1593 = select(-127f, _e1591, (_e1591 > -127f));
let _e1595 = select(128f, _e1593, (_e1593 < 128f));
let _e1602 = select(0i, select(select(i32(_e1595), i32(-2147483648), (_e1595 < -2147483600f)), 2147483647i, (_e1595 > 2147483500f)), (_e1595 == _e1595));
let _e1606 = (_e1602 - select(0i, 1i, (_e1595 < f32(_e1602))));
let _e1607 = f32(_e1606);
let _e1611 = ((_e1589 - (_e1607 * 0.6933594f)) - (_e1607 * -2.1219444e-4f));
let _e1632 = -(_e1449);
let _e1635 = global_1.member.member_13.member_2;
let _e1636 = (_e1635 * _e1635);
let _e1640 = ((1f + _e1636) - ((2f * _e1635) * _e1632));
let _e1642 = select(1e-9f, _e1640, (_e1640 > 1e-9f));
let _e1654 = global_1.member.member_13.member_3;
let _e1659 = (_e1427 * (select(((1f - _e1636) / (_e1642 * sqrt(select(0f, _e1642, (_e1642 > 0f))))), (0.75f * (1f + (_e1632 * _e1632))), (_e1654 == 1u)) * (0.25f / 3.1415927f)));
let _e1662 = global_1.member.member_13.member_1;
let _e1675 = select(0f, _e1469, (((_e1472 >= 0f) && (_e1472 < _e464)) && (_e1469 > 0f)));
if (_e1675 > _e1329) {
phi_3540_ = true;
} else {
let _e1679 = ((_e1675 > 0f) && (_e1675 < _e1319));
if _e1679 {
let _e1681 = ((_e1269 - _e1184) * _e714);
let _e1682 = (_e714 * _e1154);
let _e1683 = (1e-4f * _e1682);
let _e1685 = select(_e1198, _e1191, (_e1191 > _e1198));
let _e1687 = select(_e1683, _e1685, (_e1685 > _e1683));
let _e1689 = select(_e1198, _e1191, (_e1191 < _e1198));
let _e1691 = select(_e1683, _e1689, (_e1689 > _e1683));
let _e1692 = (0.5f * _e1682);
let _e1693 = (_e1681 + _e1692);
let _e1694 = -(_e1693);
let _e1698 = (0.5f * (_e1687 + _e1691));
let _e1699 = (_e1698 - select(_e1694, _e1693, (_e1693 > _e1694)));
let _e1701 = select(0f, _e1699, (_e1699 > 0f));
let _e1703 = select(_e1691, _e1701, (_e1701 < _e1691));
let _e1707 = (_e1699 - _e1691);
let _e1711 = ((((_e1703 * (_e1703 / _e1691)) * 0.5f) + select(0f, _e1707, (_e1707 > 0f))) / _e1687);
let _e1715 = (_e1681 - _e1692);
let _e1716 = -(_e1715);
let _e1719 = (_e1698 - select(_e1716, _e1715, (_e1715 > _e1716)));
let _e1721 = select(0f, _e1719, (_e1719 > 0f));
let _e1723 = select(_e1691, _e1721, (_e1721 < _e1691));
let _e1727 = (_e1719 - _e1691);
let _e1731 = ((((_e1723 * (_e1723 / _e1691)) * 0.5f) + select(0f, _e1727, (_e1727 > 0f))) / _e1687);
let _e1736 = ((select(_e1711, (1f - _e1711), (_e1693 >= 0f)) - select(_e1731, (1f - _e1731), (_e1715 >= 0f))) / _e1682);
let _e1742 = global_1.member.member_18.member_2;
let _e1745 = global_1.member.member_18.member_3;
let _e1748 = global_1.member.member_18.member_4;
let _e1751 = global_1.member.member_18.member_5;
if _e1295 {
phi_3140_ = 0u;
} else {
if (_e996 == 1u) {
phi_3139_ = _e1742;
} else {
if (_e996 == 2u) {
phi_3138_ = _e1745;
} else {
phi_3138_ = select(_e1751, _e1748, (_e996 == 3u));
}
let _e1757 = phi_3138_;
phi_3139_ = _e1757;
}
let _e1759 = phi_3139_;
phi_3140_ = _e1759;
}
let _e1761 = phi_3140_;
let _e1773 = (((bitcast<i32>(_e1761) + (_e1273 * bitcast<i32>((((_e1276 + (1u << bitcast<u32>(_e1151))) - 1u) >> bitcast<u32>(_e1151))))) + _e1272) * 6i);
let _e1776 = global_1.member.member_18.member;
let _e1777 = (((((_e425 * _e1662.member) * ((1f + (_e1515 * (1f + (_e1515 * (0.5f + (_e1515 * (0.16666667f + (_e1515 * (0.041666668f + (_e1515 * (0.008333334f + (_e1515 * (0.001388889f + (_e1515 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1510 + 127i)) << bitcast<u32>(23i))))) * _e1659) * _e1736) * _e1776);
if (bitcast<f32>((bitcast<u32>(_e1777) & 2147483647u)) < 1073741800f) {
let _e1783 = ((_e1777 * 1f) + 0.5f);
let _e1785 = select(-1073741800f, _e1783, (_e1783 > -1073741800f));
let _e1787 = select(1073741800f, _e1785, (_e1785 < 1073741800f));
let _e1794 = select(0i, select(select(i32(_e1787), i32(-2147483648), (_e1787 < -2147483600f)), 2147483647i, (_e1787 > 2147483500f)), (_e1787 == _e1787));
let _e1798 = (_e1794 - select(0i, 1i, (_e1787 < f32(_e1794))));
if (_e1798 == 0i) {
} else {
let _e1800 = bitcast<u32>(_e1798);
let _e1801 = bitcast<u32>(_e1773);
if (_e1801 < _e113) {
let _e1805 = atomicAdd((&global_5.member[_e1801]), _e1800);
phi_3207_ = _e1805;
} else {
phi_3207_ = 0u;
}
let _e1807 = phi_3207_;
let _e1814 = (bitcast<u32>((_e1798 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1807 + _e1800) < _e1800)));
if (_e1814 == 0u) {
} else {
let _e1816 = (_e1801 + 1u);
if (_e1816 < _e113) {
let _e1820 = atomicAdd((&global_5.member[_e1816]), _e1814);
}
}
}
} else {
let _e1823 = ((_e1777 * (1f / 1048576f)) + 0.5f);
let _e1825 = select(-1073741800f, _e1823, (_e1823 > -1073741800f));
let _e1827 = select(1073741800f, _e1825, (_e1825 < 1073741800f));
let _e1834 = select(0i, select(select(i32(_e1827), i32(-2147483648), (_e1827 < -2147483600f)), 2147483647i, (_e1827 > 2147483500f)), (_e1827 == _e1827));
let _e1838 = (_e1834 - select(0i, 1i, (_e1827 < f32(_e1834))));
let _e1841 = (bitcast<u32>(_e1838) << bitcast<u32>(20i));
let _e1842 = bitcast<u32>(_e1773);
if (_e1842 < _e113) {
let _e1846 = atomicAdd((&global_5.member[_e1842]), _e1841);
phi_3261_ = _e1846;
} else {
phi_3261_ = 0u;
}
let _e1848 = phi_3261_;
let _e1852 = (_e1842 + 1u);
if (_e1852 < _e113) {
let _e1860 = atomicAdd((&global_5.member[_e1852]), (bitcast<u32>((_e1838 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e1848 + _e1841) < _e1841))));
}
}
let _e1861 = (_e1773 + 2i);
let _e1862 = (((((_e438 * _e1662.member_1) * ((1f + (_e1563 * (1f + (_e1563 * (0.5f + (_e1563 * (0.16666667f + (_e1563 * (0.041666668f + (_e1563 * (0.008333334f + (_e1563 * (0.001388889f + (_e1563 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1558 + 127i)) << bitcast<u32>(23i))))) * _e1659) * _e1736) * _e1776);
if (bitcast<f32>((bitcast<u32>(_e1862) & 2147483647u)) < 1073741800f) {
let _e1868 = ((_e1862 * 1f) + 0.5f);
let _e1870 = select(-1073741800f, _e1868, (_e1868 > -1073741800f));
let _e1872 = select(1073741800f, _e1870, (_e1870 < 1073741800f));
let _e1879 = select(0i, select(select(i32(_e1872), i32(-2147483648), (_e1872 < -2147483600f)), 2147483647i, (_e1872 > 2147483500f)), (_e1872 == _e1872));
let _e1883 = (_e1879 - select(0i, 1i, (_e1872 < f32(_e1879))));
if (_e1883 == 0i) {
} else {
let _e1885 = bitcast<u32>(_e1883);
let _e1886 = bitcast<u32>(_e1861);
if (_e1886 < _e113) {
let _e1890 = atomicAdd((&global_5.member[_e1886]), _e1885);
phi_3325_ = _e1890;
} else {
phi_3325_ = 0u;
}
let _e1892 = phi_3325_;
let _e1899 = (bitcast<u32>((_e1883 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1892 + _e1885) < _e1885)));
if (_e1899 == 0u) {
} else {
let _e1901 = (_e1886 + 1u);
if (_e1901 < _e113) {
let _e1905 = atomicAdd((&global_5.member[_e1901]), _e1899);
}
}
}
} else {
let _e1908 = ((_e1862 * (1f / 1048576f)) + 0.5f);
let _e1910 = select(-1073741800f, _e1908, (_e1908 > -1073741800f));
let _e1912 = select(1073741800f, _e1910, (_e1910 < 1073741800f));
let _e1919 = select(0i, select(select(i32(_e1912), i32(-2147483648), (_e1912 < -2147483600f)), 2147483647i, (_e1912 > 2147483500f)), (_e1912 == _e1912));
let _e1923 = (_e1919 - select(0i, 1i, (_e1912 < f32(_e1919))));
let _e1926 = (bitcast<u32>(_e1923) << bitcast<u32>(20i));
let _e1927 = bitcast<u32>(_e1861);
if (_e1927 < _e113) {
let _e1931 = atomicAdd((&global_5.member[_e1927]), _e1926);
phi_3379_ = _e1931;
} else {
phi_3379_ = 0u;
}
let _e1933 = phi_3379_;
let _e1937 = (_e1927 + 1u);
if (_e1937 < _e113) {
let _e1945 = atomicAdd((&global_5.member[_e1937]), (bitcast<u32>((_e1923 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e1933 + _e1926) < _e1926))));
}
}
let _e1946 = (_e1773 + 4i);
let _e1947 = (((((_e451 * _e1662.member_2) * ((1f + (_e1611 * (1f + (_e1611 * (0.5f + (_e1611 * (0.16666667f + (_e1611 * (0.041666668f + (_e1611 * (0.008333334f + (_e1611 * (0.001388889f + (_e1611 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1606 + 127i)) << bitcast<u32>(23i))))) * _e1659) * _e1736) * _e1776);
if (bitcast<f32>((bitcast<u32>(_e1947) & 2147483647u)) < 1073741800f) {
let _e1953 = ((_e1947 * 1f) + 0.5f);
let _e1955 = select(-1073741800f, _e1953, (_e1953 > -1073741800f));
let _e1957 = select(1073741800f, _e1955, (_e1955 < 1073741800f));
let _e1964 = select(0i, select(select(i32(_e1957), i32(-2147483648), (_e1957 < -2147483600f)), 2147483647i, (_e1957 > 2147483500f)), (_e1957 == _e1957));
let _e1968 = (_e1964 - select(0i, 1i, (_e1957 < f32(_e1964))));
if (_e1968 == 0i) {
} else {
let _e1970 = bitcast<u32>(_e1968);
let _e1971 = bitcast<u32>(_e1946);
if (_e1971 < _e113) {
let _e1975 = atomicAdd((&global_5.member[_e1971]), _e1970);
phi_3443_ = _e1975;
} else {
phi_3443_ = 0u;
}
let _e1977 = phi_3443_;
let _e1984 = (bitcast<u32>((_e1968 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1977 + _e1970) < _e1970)));
if (_e1984 == 0u) {
} else {
let _e1986 = (_e1971 + 1u);
if (_e1986 < _e113) {
let _e1990 = atomicAdd((&global_5.member[_e1986]), _e1984);
}
}
}
} else {
let _e1993 = ((_e1947 * (1f / 1048576f)) + 0.5f);
let _e1995 = select(-1073741800f, _e1993, (_e1993 > -1073741800f));
let _e1997 = select(1073741800f, _e1995, (_e1995 < 1073741800f));
let _e2004 = select(0i, select(select(i32(_e1997), i32(-2147483648), (_e1997 < -2147483600f)), 2147483647i, (_e1997 > 2147483500f)), (_e1997 == _e1997));
let _e2008 = (_e2004 - select(0i, 1i, (_e1997 < f32(_e2004))));
let _e2011 = (bitcast<u32>(_e2008) << bitcast<u32>(20i));
let _e2012 = bitcast<u32>(_e1946);
if (_e2012 < _e113) {
let _e2016 = atomicAdd((&global_5.member[_e2012]), _e2011);
phi_3497_ = _e2016;
} else {
phi_3497_ = 0u;
}
let _e2018 = phi_3497_;
let _e2022 = (_e2012 + 1u);
if (_e2022 < _e113) {
let _e2030 = atomicAdd((&global_5.member[_e2022]), (bitcast<u32>((_e2008 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e2018 + _e2011) < _e2011))));
}
}
}
phi_3540_ = ((_e1679 && ((!(((_e1175 * _e1153) == _e904)) || (_e1073 == _e996)) && (!((((_e1175 + 1i) * _e1153) == _e905)) || (_e1150 == _e996)))) && ((_e1675 * (1f + (0.02f * _e1154))) < _e1340));
}
let _e2050 = phi_3540_;
phi_3546_ = select(true, false, _e2050);
} else {
phi_3546_ = true;
}
let _e2053 = phi_3546_;
if _e2053 {
let _e2057 = global_1.member.member_1.member;
let _e2058 = bitcast<i32>(_e2057);
let _e2061 = global_1.member.member_1.member_1;
let _e2062 = bitcast<i32>(_e2061);
phi_3568_ = (_e1175 * _e1153);
loop {
let _e2067 = phi_3568_;
let _e2072 = ((_e2067 < ((_e1175 + 1i) * _e1153)) && (_e2067 < select(_e2058, _e2062, _e705)));
if _e2072 {
let _e2073 = (_e996 == 0u);
if _e2073 {
phi_3614_ = type_5(_e1184, _e1191, _e1198);
} else {
let _e2074 = f32(_e2067);
let _e2078 = (-(((_e706 * _e2074) + _e586)) / _e707);
phi_3614_ = type_5(_e2078, bitcast<f32>((bitcast<u32>(((_e708 * _e2074) + ((_e709 * _e2078) + _e642))) & 2147483647u)), bitcast<f32>((bitcast<u32>(((_e710 * _e2074) + ((_e711 * _e2078) + _e698))) & 2147483647u)));
}
let _e2095 = phi_3614_;
phi_3617_ = (_e1246 * _e1153);
loop {
let _e2098 = phi_3617_;
let _e2103 = ((_e2098 < ((_e1246 + 1i) * _e1153)) && (_e2098 < select(_e2062, _e2058, _e705)));
if _e2103 {
if select((((_e1073 > 0u) && ((2i * (_e1175 - _e904)) < (1i << bitcast<u32>((_e1073 & 31u))))) || ((_e1150 > 0u) && ((2i * (_e919 - _e1175)) < (1i << bitcast<u32>((_e1150 & 31u)))))), true, _e1265) {
if _e2073 {
phi_5746_ = 1f;
} else {
let _e2105 = (1u << bitcast<u32>(_e1151));
let _e2109 = (((_e2057 + _e2105) - 1u) >> bitcast<u32>(_e1151));
let _e2113 = (((_e2061 + _e2105) - 1u) >> bitcast<u32>(_e1151));
if _e705 {
phi_3666_ = bitcast<i32>(_e2109);
phi_3667_ = bitcast<i32>(_e2113);
} else {
phi_3666_ = bitcast<i32>(_e2113);
phi_3667_ = bitcast<i32>(_e2109);
}
let _e2119 = phi_3666_;
let _e2121 = phi_3667_;
let _e2122 = (1f / _e1154);
let _e2126 = (((f32(_e2067) + 0.5f) * _e2122) - 0.5f);
let _e2130 = (((f32(_e2098) + 0.5f) * _e2122) - 0.5f);
let _e2132 = select(-1f, _e2126, (_e2126 > -1f));
let _e2134 = select(1e6f, _e2132, (_e2132 < 1e6f));
let _e2141 = select(0i, select(select(i32(_e2134), i32(-2147483648), (_e2134 < -2147483600f)), 2147483647i, (_e2134 > 2147483500f)), (_e2134 == _e2134));
let _e2145 = (_e2141 - select(0i, 1i, (_e2134 < f32(_e2141))));
let _e2147 = select(-1f, _e2130, (_e2130 > -1f));
let _e2149 = select(1e6f, _e2147, (_e2147 < 1e6f));
let _e2156 = select(0i, select(select(i32(_e2149), i32(-2147483648), (_e2149 < -2147483600f)), 2147483647i, (_e2149 > 2147483500f)), (_e2149 == _e2149));
let _e2160 = (_e2156 - select(0i, 1i, (_e2149 < f32(_e2156))));
let _e2162 = (_e2126 - f32(_e2145));
let _e2164 = (_e2130 - f32(_e2160));
let _e2165 = (1f - _e2162);
let _e2166 = (1f - _e2164);
let _e2169 = select(_e2145, 0i, (_e2145 < 0i));
let _e2170 = (_e2169 >= _e2121);
if _e2170 {
phi_3743_ = (_e2121 - 1i);
} else {
phi_3743_ = _e2169;
}
let _e2173 = phi_3743_;
let _e2175 = select(_e2160, 0i, (_e2160 < 0i));
let _e2176 = (_e2175 >= _e2119);
if _e2176 {
phi_3754_ = (_e2119 - 1i);
} else {
phi_3754_ = _e2175;
}
let _e2179 = phi_3754_;
let _e2183 = (((f32(_e2173) + 0.5f) * _e1154) - 0.5f);
let _e2187 = (((f32(_e2179) + 0.5f) * _e1154) - 0.5f);
let _e2195 = bitcast<i32>(((_e2057 + 1u) >> bitcast<u32>(1u)));
let _e2198 = global_1.member.member_18.member_6;
let _e2201 = global_1.member.member_18.member_7;
let _e2204 = global_1.member.member_18.member_8;
if _e2073 {
phi_3830_ = 0u;
} else {
if (_e996 == 1u) {
phi_3829_ = 0u;
} else {
if (_e996 == 2u) {
phi_3828_ = _e2198;
} else {
phi_3828_ = select(_e2204, _e2201, (_e996 == 3u));
}
let _e2210 = phi_3828_;
phi_3829_ = _e2210;
}
let _e2212 = phi_3829_;
phi_3830_ = _e2212;
}
let _e2214 = phi_3830_;
local_22 = (((bitcast<i32>(_e2214) + select(_e2179, _e2173, _e705)) * _e2195) + select(_e2173, _e2179, _e705));
let _e2219 = local_22;
let _e2221 = (bitcast<i32>(_e111) - 1i);
let _e2223 = select(_e2221, _e2219, (_e2219 < _e2221));
let _e2228 = global_4.member[bitcast<u32>(select(0i, _e2223, (_e2223 > 0i)))];
let _e2229 = f32(_e2058);
let _e2230 = f32(_e2062);
let _e2237 = global_1.member.member_2.member;
let _e2238 = (((((select(_e2183, _e2187, _e705) + 0.5f) / _e2229) * 2f) - 1f) * _e2237);
let _e2245 = global_1.member.member_2.member_1;
let _e2246 = ((1f - (((select(_e2187, _e2183, _e705) + 0.5f) / _e2230) * 2f)) * _e2245);
let _e2248 = global_1.member.member_3;
let _e2256 = global_1.member.member_4;
let _e2263 = ((_e2248.member * _e2238) + (_e2256.member * _e2246));
let _e2264 = ((_e2248.member_1 * _e2238) + (_e2256.member_1 * _e2246));
let _e2265 = ((_e2248.member_2 * _e2238) + (_e2256.member_2 * _e2246));
let _e2268 = global_1.member.member_2.member_3;
let _e2269 = (_e2268 != 0u);
let _e2271 = global_1.member.member_5;
let _e2278 = select((_e2271.member + _e2263), _e2271.member, _e2269);
let _e2279 = select((_e2271.member_1 + _e2264), _e2271.member_1, _e2269);
let _e2280 = select((_e2271.member_2 + _e2265), _e2271.member_2, _e2269);
let _e2282 = global_1.member.member_6;
let _e2296 = (((_e2278 * _e2278) + (_e2279 * _e2279)) + (_e2280 * _e2280));
let _e2300 = (1f / sqrt(select(0f, _e2296, (_e2296 > 0f))));
let _e2301 = (_e2278 * _e2300);
let _e2302 = (_e2279 * _e2300);
let _e2303 = (_e2280 * _e2300);
let _e2304 = (_e192 - select(_e2282.member, (_e2282.member + _e2263), _e2269));
let _e2305 = (_e204 - select(_e2282.member_1, (_e2282.member_1 + _e2264), _e2269));
let _e2306 = (_e217 - select(_e2282.member_2, (_e2282.member_2 + _e2265), _e2269));
let _e2311 = (((_e2304 * _e2301) + (_e2305 * _e2302)) + (_e2306 * _e2303));
let _e2316 = (((_e2304 * _e230) + (_e2305 * _e243)) + (_e2306 * _e256));
let _e2321 = (((_e2301 * _e230) + (_e2302 * _e243)) + (_e2303 * _e256));
let _e2324 = ((_e2302 * _e256) - (_e2303 * _e243));
let _e2327 = ((_e2303 * _e230) - (_e2301 * _e256));
let _e2330 = ((_e2301 * _e243) - (_e2302 * _e230));
let _e2335 = (((_e2324 * _e2324) + (_e2327 * _e2327)) + (_e2330 * _e2330));
let _e2338 = (1f / select(1e-9f, _e2335, (_e2335 > 1e-9f)));
let _e2341 = ((_e2311 - (_e2321 * _e2316)) * _e2338);
let _e2344 = (((_e2321 * _e2311) - _e2316) * _e2338);
let _e2350 = select(0f, _e2341, (((_e2344 >= 0f) && (_e2344 < _e464)) && (_e2341 > 0f)));
let _e2352 = (_e2173 << bitcast<u32>(_e1151));
if (_e2352 < _e904) {
phi_4223_ = _e1073;
} else {
phi_4223_ = select(_e996, _e1150, (_e2352 >= _e905));
}
let _e2357 = phi_4223_;
let _e2365 = (_e2145 + 1i);
let _e2368 = select(_e2365, 0i, (_e2365 < 0i));
let _e2369 = (_e2368 >= _e2121);
if _e2369 {
phi_4247_ = (_e2121 - 1i);
} else {
phi_4247_ = _e2368;
}
let _e2372 = phi_4247_;
if _e2176 {
phi_4258_ = (_e2119 - 1i);
} else {
phi_4258_ = _e2175;
}
let _e2375 = phi_4258_;
let _e2379 = (((f32(_e2372) + 0.5f) * _e1154) - 0.5f);
let _e2383 = (((f32(_e2375) + 0.5f) * _e1154) - 0.5f);
if _e2073 {
phi_4334_ = 0u;
} else {
if (_e996 == 1u) {
phi_4333_ = 0u;
} else {
if (_e996 == 2u) {
phi_4332_ = _e2198;
} else {
phi_4332_ = select(_e2204, _e2201, (_e996 == 3u));
}
let _e2393 = phi_4332_;
phi_4333_ = _e2393;
}
let _e2395 = phi_4333_;
phi_4334_ = _e2395;
}
let _e2397 = phi_4334_;
local_20 = (((bitcast<i32>(_e2397) + select(_e2375, _e2372, _e705)) * _e2195) + select(_e2372, _e2375, _e705));
let _e2402 = local_20;
let _e2404 = select(_e2221, _e2402, (_e2402 < _e2221));
let _e2409 = global_4.member[bitcast<u32>(select(0i, _e2404, (_e2404 > 0i)))];
let _e2414 = (((((select(_e2379, _e2383, _e705) + 0.5f) / _e2229) * 2f) - 1f) * _e2237);
let _e2419 = ((1f - (((select(_e2383, _e2379, _e705) + 0.5f) / _e2230) * 2f)) * _e2245);
let _e2426 = ((_e2248.member * _e2414) + (_e2256.member * _e2419));
let _e2427 = ((_e2248.member_1 * _e2414) + (_e2256.member_1 * _e2419));
let _e2428 = ((_e2248.member_2 * _e2414) + (_e2256.member_2 * _e2419));
let _e2432 = select((_e2271.member + _e2426), _e2271.member, _e2269);
let _e2433 = select((_e2271.member_1 + _e2427), _e2271.member_1, _e2269);
let _e2434 = select((_e2271.member_2 + _e2428), _e2271.member_2, _e2269);
let _e2445 = (((_e2432 * _e2432) + (_e2433 * _e2433)) + (_e2434 * _e2434));
let _e2449 = (1f / sqrt(select(0f, _e2445, (_e2445 > 0f))));
let _e2450 = (_e2432 * _e2449);
let _e2451 = (_e2433 * _e2449);
let _e2452 = (_e2434 * _e2449);
let _e2453 = (_e192 - select(_e2282.member, (_e2282.member + _e2426), _e2269));
let _e2454 = (_e204 - select(_e2282.member_1, (_e2282.member_1 + _e2427), _e2269));
let _e2455 = (_e217 - select(_e2282.member_2, (_e2282.member_2 + _e2428), _e2269));
let _e2460 = (((_e2453 * _e2450) + (_e2454 * _e2451)) + (_e2455 * _e2452));
let _e2465 = (((_e2453 * _e230) + (_e2454 * _e243)) + (_e2455 * _e256));
let _e2470 = (((_e2450 * _e230) + (_e2451 * _e243)) + (_e2452 * _e256));
let _e2473 = ((_e2451 * _e256) - (_e2452 * _e243));
let _e2476 = ((_e2452 * _e230) - (_e2450 * _e256));
let _e2479 = ((_e2450 * _e243) - (_e2451 * _e230));
let _e2484 = (((_e2473 * _e2473) + (_e2476 * _e2476)) + (_e2479 * _e2479));
let _e2487 = (1f / select(1e-9f, _e2484, (_e2484 > 1e-9f)));
let _e2490 = ((_e2460 - (_e2470 * _e2465)) * _e2487);
let _e2493 = (((_e2470 * _e2460) - _e2465) * _e2487);
let _e2499 = select(0f, _e2490, (((_e2493 >= 0f) && (_e2493 < _e464)) && (_e2490 > 0f)));
let _e2501 = (_e2372 << bitcast<u32>(_e1151));
if (_e2501 < _e904) {
phi_4727_ = _e1073;
} else {
phi_4727_ = select(_e996, _e1150, (_e2501 >= _e905));
}
let _e2506 = phi_4727_;
let _e2514 = (_e2160 + 1i);
if _e2170 {
phi_4751_ = (_e2121 - 1i);
} else {
phi_4751_ = _e2169;
}
let _e2518 = phi_4751_;
let _e2520 = select(_e2514, 0i, (_e2514 < 0i));
let _e2521 = (_e2520 >= _e2119);
if _e2521 {
phi_4762_ = (_e2119 - 1i);
} else {
phi_4762_ = _e2520;
}
let _e2524 = phi_4762_;
let _e2528 = (((f32(_e2518) + 0.5f) * _e1154) - 0.5f);
let _e2532 = (((f32(_e2524) + 0.5f) * _e1154) - 0.5f);
if _e2073 {
phi_4838_ = 0u;
} else {
if (_e996 == 1u) {
phi_4837_ = 0u;
} else {
if (_e996 == 2u) {
phi_4836_ = _e2198;
} else {
phi_4836_ = select(_e2204, _e2201, (_e996 == 3u));
}
let _e2542 = phi_4836_;
phi_4837_ = _e2542;
}
let _e2544 = phi_4837_;
phi_4838_ = _e2544;
}
let _e2546 = phi_4838_;
local_18 = (((bitcast<i32>(_e2546) + select(_e2524, _e2518, _e705)) * _e2195) + select(_e2518, _e2524, _e705));
let _e2551 = local_18;
let _e2553 = select(_e2221, _e2551, (_e2551 < _e2221));
let _e2558 = global_4.member[bitcast<u32>(select(0i, _e2553, (_e2553 > 0i)))];
let _e2563 = (((((select(_e2528, _e2532, _e705) + 0.5f) / _e2229) * 2f) - 1f) * _e2237);
let _e2568 = ((1f - (((select(_e2532, _e2528, _e705) + 0.5f) / _e2230) * 2f)) * _e2245);
let _e2575 = ((_e2248.member * _e2563) + (_e2256.member * _e2568));
let _e2576 = ((_e2248.member_1 * _e2563) + (_e2256.member_1 * _e2568));
let _e2577 = ((_e2248.member_2 * _e2563) + (_e2256.member_2 * _e2568));
let _e2581 = select((_e2271.member + _e2575), _e2271.member, _e2269);
let _e2582 = select((_e2271.member_1 + _e2576), _e2271.member_1, _e2269);
let _e2583 = select((_e2271.member_2 + _e2577), _e2271.member_2, _e2269);
let _e2594 = (((_e2581 * _e2581) + (_e2582 * _e2582)) + (_e2583 * _e2583));
let _e2598 = (1f / sqrt(select(0f, _e2594, (_e2594 > 0f))));
let _e2599 = (_e2581 * _e2598);
let _e2600 = (_e2582 * _e2598);
let _e2601 = (_e2583 * _e2598);
let _e2602 = (_e192 - select(_e2282.member, (_e2282.member + _e2575), _e2269));
let _e2603 = (_e204 - select(_e2282.member_1, (_e2282.member_1 + _e2576), _e2269));
let _e2604 = (_e217 - select(_e2282.member_2, (_e2282.member_2 + _e2577), _e2269));
let _e2609 = (((_e2602 * _e2599) + (_e2603 * _e2600)) + (_e2604 * _e2601));
let _e2614 = (((_e2602 * _e230) + (_e2603 * _e243)) + (_e2604 * _e256));
let _e2619 = (((_e2599 * _e230) + (_e2600 * _e243)) + (_e2601 * _e256));
let _e2622 = ((_e2600 * _e256) - (_e2601 * _e243));
let _e2625 = ((_e2601 * _e230) - (_e2599 * _e256));
let _e2628 = ((_e2599 * _e243) - (_e2600 * _e230));
let _e2633 = (((_e2622 * _e2622) + (_e2625 * _e2625)) + (_e2628 * _e2628));
let _e2636 = (1f / select(1e-9f, _e2633, (_e2633 > 1e-9f)));
let _e2639 = ((_e2609 - (_e2619 * _e2614)) * _e2636);
let _e2642 = (((_e2619 * _e2609) - _e2614) * _e2636);
let _e2648 = select(0f, _e2639, (((_e2642 >= 0f) && (_e2642 < _e464)) && (_e2639 > 0f)));
let _e2650 = (_e2518 << bitcast<u32>(_e1151));
if (_e2650 < _e904) {
phi_5231_ = _e1073;
} else {
phi_5231_ = select(_e996, _e1150, (_e2650 >= _e905));
}
let _e2655 = phi_5231_;
if _e2369 {
phi_5255_ = (_e2121 - 1i);
} else {
phi_5255_ = _e2368;
}
let _e2666 = phi_5255_;
if _e2521 {
phi_5266_ = (_e2119 - 1i);
} else {
phi_5266_ = _e2520;
}
let _e2669 = phi_5266_;
let _e2673 = (((f32(_e2666) + 0.5f) * _e1154) - 0.5f);
let _e2677 = (((f32(_e2669) + 0.5f) * _e1154) - 0.5f);
if _e2073 {
phi_5342_ = 0u;
} else {
if (_e996 == 1u) {
phi_5341_ = 0u;
} else {
if (_e996 == 2u) {
phi_5340_ = _e2198;
} else {
phi_5340_ = select(_e2204, _e2201, (_e996 == 3u));
}
let _e2687 = phi_5340_;
phi_5341_ = _e2687;
}
let _e2689 = phi_5341_;
phi_5342_ = _e2689;
}
let _e2691 = phi_5342_;
local_16 = (((bitcast<i32>(_e2691) + select(_e2669, _e2666, _e705)) * _e2195) + select(_e2666, _e2669, _e705));
let _e2696 = local_16;
let _e2698 = select(_e2221, _e2696, (_e2696 < _e2221));
let _e2703 = global_4.member[bitcast<u32>(select(0i, _e2698, (_e2698 > 0i)))];
let _e2708 = (((((select(_e2673, _e2677, _e705) + 0.5f) / _e2229) * 2f) - 1f) * _e2237);
let _e2713 = ((1f - (((select(_e2677, _e2673, _e705) + 0.5f) / _e2230) * 2f)) * _e2245);
let _e2720 = ((_e2248.member * _e2708) + (_e2256.member * _e2713));
let _e2721 = ((_e2248.member_1 * _e2708) + (_e2256.member_1 * _e2713));
let _e2722 = ((_e2248.member_2 * _e2708) + (_e2256.member_2 * _e2713));
let _e2726 = select((_e2271.member + _e2720), _e2271.member, _e2269);
let _e2727 = select((_e2271.member_1 + _e2721), _e2271.member_1, _e2269);
let _e2728 = select((_e2271.member_2 + _e2722), _e2271.member_2, _e2269);
let _e2739 = (((_e2726 * _e2726) + (_e2727 * _e2727)) + (_e2728 * _e2728));
let _e2743 = (1f / sqrt(select(0f, _e2739, (_e2739 > 0f))));
let _e2744 = (_e2726 * _e2743);
let _e2745 = (_e2727 * _e2743);
let _e2746 = (_e2728 * _e2743);
let _e2747 = (_e192 - select(_e2282.member, (_e2282.member + _e2720), _e2269));
let _e2748 = (_e204 - select(_e2282.member_1, (_e2282.member_1 + _e2721), _e2269));
let _e2749 = (_e217 - select(_e2282.member_2, (_e2282.member_2 + _e2722), _e2269));
let _e2754 = (((_e2747 * _e2744) + (_e2748 * _e2745)) + (_e2749 * _e2746));
let _e2759 = (((_e2747 * _e230) + (_e2748 * _e243)) + (_e2749 * _e256));
let _e2764 = (((_e2744 * _e230) + (_e2745 * _e243)) + (_e2746 * _e256));
let _e2767 = ((_e2745 * _e256) - (_e2746 * _e243));
let _e2770 = ((_e2746 * _e230) - (_e2744 * _e256));
let _e2773 = ((_e2744 * _e243) - (_e2745 * _e230));
let _e2778 = (((_e2767 * _e2767) + (_e2770 * _e2770)) + (_e2773 * _e2773));
let _e2781 = (1f / select(1e-9f, _e2778, (_e2778 > 1e-9f)));
let _e2784 = ((_e2754 - (_e2764 * _e2759)) * _e2781);
let _e2787 = (((_e2764 * _e2754) - _e2759) * _e2781);
let _e2793 = select(0f, _e2784, (((_e2787 >= 0f) && (_e2787 < _e464)) && (_e2784 > 0f)));
let _e2795 = (_e2666 << bitcast<u32>(_e1151));
if (_e2795 < _e904) {
phi_5735_ = _e1073;
} else {
phi_5735_ = select(_e996, _e1150, (_e2795 >= _e905));
}
let _e2800 = phi_5735_;
phi_5746_ = ((((1f - select(0f, (_e2165 * _e2166), (((_e2357 == _e996) && (_e2350 > 0f)) && (_e2350 < _e2228)))) - select(0f, (_e2162 * _e2166), (((_e2506 == _e996) && (_e2499 > 0f)) && (_e2499 < _e2409)))) - select(0f, (_e2165 * _e2164), (((_e2655 == _e996) && (_e2648 > 0f)) && (_e2648 < _e2558)))) - select(0f, (_e2162 * _e2164), (((_e2800 == _e996) && (_e2793 > 0f)) && (_e2793 < _e2703))));
}
let _e2809 = phi_5746_;
let _e2811 = select(_e1073, 0u, (_e1073 == _e996));
let _e2812 = (_e2811 == 0u);
if _e2812 {
phi_7862_ = _e2809;
} else {
let _e2813 = (_e2811 & 31u);
let _e2815 = (1u << bitcast<u32>(_e2813));
let _e2819 = (((_e2057 + _e2815) - 1u) >> bitcast<u32>(_e2813));
let _e2823 = (((_e2061 + _e2815) - 1u) >> bitcast<u32>(_e2813));
if _e705 {
phi_5782_ = bitcast<i32>(_e2819);
phi_5783_ = bitcast<i32>(_e2823);
} else {
phi_5782_ = bitcast<i32>(_e2823);
phi_5783_ = bitcast<i32>(_e2819);
}
let _e2829 = phi_5782_;
let _e2831 = phi_5783_;
let _e2834 = f32((1i << bitcast<u32>(_e2813)));
let _e2835 = (1f / _e2834);
let _e2839 = (((f32(_e2067) + 0.5f) * _e2835) - 0.5f);
let _e2843 = (((f32(_e2098) + 0.5f) * _e2835) - 0.5f);
let _e2845 = select(-1f, _e2839, (_e2839 > -1f));
let _e2847 = select(1e6f, _e2845, (_e2845 < 1e6f));
let _e2854 = select(0i, select(select(i32(_e2847), i32(-2147483648), (_e2847 < -2147483600f)), 2147483647i, (_e2847 > 2147483500f)), (_e2847 == _e2847));
let _e2858 = (_e2854 - select(0i, 1i, (_e2847 < f32(_e2854))));
let _e2860 = select(-1f, _e2843, (_e2843 > -1f));
let _e2862 = select(1e6f, _e2860, (_e2860 < 1e6f));
let _e2869 = select(0i, select(select(i32(_e2862), i32(-2147483648), (_e2862 < -2147483600f)), 2147483647i, (_e2862 > 2147483500f)), (_e2862 == _e2862));
let _e2873 = (_e2869 - select(0i, 1i, (_e2862 < f32(_e2869))));
let _e2875 = (_e2839 - f32(_e2858));
let _e2877 = (_e2843 - f32(_e2873));
let _e2878 = (1f - _e2875);
let _e2879 = (1f - _e2877);
let _e2882 = select(_e2858, 0i, (_e2858 < 0i));
let _e2883 = (_e2882 >= _e2831);
if _e2883 {
phi_5859_ = (_e2831 - 1i);
} else {
phi_5859_ = _e2882;
}
let _e2886 = phi_5859_;
let _e2888 = select(_e2873, 0i, (_e2873 < 0i));
let _e2889 = (_e2888 >= _e2829);
if _e2889 {
phi_5870_ = (_e2829 - 1i);
} else {
phi_5870_ = _e2888;
}
let _e2892 = phi_5870_;
let _e2896 = (((f32(_e2886) + 0.5f) * _e2834) - 0.5f);
let _e2900 = (((f32(_e2892) + 0.5f) * _e2834) - 0.5f);
let _e2908 = bitcast<i32>(((_e2057 + 1u) >> bitcast<u32>(1u)));
let _e2911 = global_1.member.member_18.member_6;
let _e2914 = global_1.member.member_18.member_7;
let _e2917 = global_1.member.member_18.member_8;
if _e2812 {
phi_5946_ = 0u;
} else {
if (_e2811 == 1u) {
phi_5945_ = 0u;
} else {
if (_e2811 == 2u) {
phi_5944_ = _e2911;
} else {
phi_5944_ = select(_e2917, _e2914, (_e2811 == 3u));
}
let _e2923 = phi_5944_;
phi_5945_ = _e2923;
}
let _e2925 = phi_5945_;
phi_5946_ = _e2925;
}
let _e2927 = phi_5946_;
local_14 = (((bitcast<i32>(_e2927) + select(_e2892, _e2886, _e705)) * _e2908) + select(_e2886, _e2892, _e705));
let _e2932 = local_14;
let _e2934 = (bitcast<i32>(_e111) - 1i);
let _e2936 = select(_e2934, _e2932, (_e2932 < _e2934));
let _e2941 = global_4.member[bitcast<u32>(select(0i, _e2936, (_e2936 > 0i)))];
let _e2942 = f32(_e2058);
let _e2943 = f32(_e2062);
let _e2950 = global_1.member.member_2.member;
let _e2951 = (((((select(_e2896, _e2900, _e705) + 0.5f) / _e2942) * 2f) - 1f) * _e2950);
let _e2958 = global_1.member.member_2.member_1;
let _e2959 = ((1f - (((select(_e2900, _e2896, _e705) + 0.5f) / _e2943) * 2f)) * _e2958);
let _e2961 = global_1.member.member_3;
let _e2969 = global_1.member.member_4;
let _e2976 = ((_e2961.member * _e2951) + (_e2969.member * _e2959));
let _e2977 = ((_e2961.member_1 * _e2951) + (_e2969.member_1 * _e2959));
let _e2978 = ((_e2961.member_2 * _e2951) + (_e2969.member_2 * _e2959));
let _e2981 = global_1.member.member_2.member_3;
let _e2982 = (_e2981 != 0u);
let _e2984 = global_1.member.member_5;
let _e2991 = select((_e2984.member + _e2976), _e2984.member, _e2982);
let _e2992 = select((_e2984.member_1 + _e2977), _e2984.member_1, _e2982);
let _e2993 = select((_e2984.member_2 + _e2978), _e2984.member_2, _e2982);
let _e2995 = global_1.member.member_6;
let _e3009 = (((_e2991 * _e2991) + (_e2992 * _e2992)) + (_e2993 * _e2993));
let _e3013 = (1f / sqrt(select(0f, _e3009, (_e3009 > 0f))));
let _e3014 = (_e2991 * _e3013);
let _e3015 = (_e2992 * _e3013);
let _e3016 = (_e2993 * _e3013);
let _e3017 = (_e192 - select(_e2995.member, (_e2995.member + _e2976), _e2982));
let _e3018 = (_e204 - select(_e2995.member_1, (_e2995.member_1 + _e2977), _e2982));
let _e3019 = (_e217 - select(_e2995.member_2, (_e2995.member_2 + _e2978), _e2982));
let _e3024 = (((_e3017 * _e3014) + (_e3018 * _e3015)) + (_e3019 * _e3016));
let _e3029 = (((_e3017 * _e230) + (_e3018 * _e243)) + (_e3019 * _e256));
let _e3034 = (((_e3014 * _e230) + (_e3015 * _e243)) + (_e3016 * _e256));
let _e3037 = ((_e3015 * _e256) - (_e3016 * _e243));
let _e3040 = ((_e3016 * _e230) - (_e3014 * _e256));
let _e3043 = ((_e3014 * _e243) - (_e3015 * _e230));
let _e3048 = (((_e3037 * _e3037) + (_e3040 * _e3040)) + (_e3043 * _e3043));
let _e3051 = (1f / select(1e-9f, _e3048, (_e3048 > 1e-9f)));
let _e3054 = ((_e3024 - (_e3034 * _e3029)) * _e3051);
let _e3057 = (((_e3034 * _e3024) - _e3029) * _e3051);
let _e3063 = select(0f, _e3054, (((_e3057 >= 0f) && (_e3057 < _e464)) && (_e3054 > 0f)));
let _e3065 = (_e2886 << bitcast<u32>(_e2813));
if (_e3065 < _e904) {
phi_6339_ = _e1073;
} else {
phi_6339_ = select(_e996, _e1150, (_e3065 >= _e905));
}
let _e3070 = phi_6339_;
let _e3078 = (_e2858 + 1i);
let _e3081 = select(_e3078, 0i, (_e3078 < 0i));
let _e3082 = (_e3081 >= _e2831);
if _e3082 {
phi_6363_ = (_e2831 - 1i);
} else {
phi_6363_ = _e3081;
}
let _e3085 = phi_6363_;
if _e2889 {
phi_6374_ = (_e2829 - 1i);
} else {
phi_6374_ = _e2888;
}
let _e3088 = phi_6374_;
let _e3092 = (((f32(_e3085) + 0.5f) * _e2834) - 0.5f);
let _e3096 = (((f32(_e3088) + 0.5f) * _e2834) - 0.5f);
if _e2812 {
phi_6450_ = 0u;
} else {
if (_e2811 == 1u) {
phi_6449_ = 0u;
} else {
if (_e2811 == 2u) {
phi_6448_ = _e2911;
} else {
phi_6448_ = select(_e2917, _e2914, (_e2811 == 3u));
}
let _e3106 = phi_6448_;
phi_6449_ = _e3106;
}
let _e3108 = phi_6449_;
phi_6450_ = _e3108;
}
let _e3110 = phi_6450_;
local_12 = (((bitcast<i32>(_e3110) + select(_e3088, _e3085, _e705)) * _e2908) + select(_e3085, _e3088, _e705));
let _e3115 = local_12;
let _e3117 = select(_e2934, _e3115, (_e3115 < _e2934));
let _e3122 = global_4.member[bitcast<u32>(select(0i, _e3117, (_e3117 > 0i)))];
let _e3127 = (((((select(_e3092, _e3096, _e705) + 0.5f) / _e2942) * 2f) - 1f) * _e2950);
let _e3132 = ((1f - (((select(_e3096, _e3092, _e705) + 0.5f) / _e2943) * 2f)) * _e2958);
let _e3139 = ((_e2961.member * _e3127) + (_e2969.member * _e3132));
let _e3140 = ((_e2961.member_1 * _e3127) + (_e2969.member_1 * _e3132));
let _e3141 = ((_e2961.member_2 * _e3127) + (_e2969.member_2 * _e3132));
let _e3145 = select((_e2984.member + _e3139), _e2984.member, _e2982);
let _e3146 = select((_e2984.member_1 + _e3140), _e2984.member_1, _e2982);
let _e3147 = select((_e2984.member_2 + _e3141), _e2984.member_2, _e2982);
let _e3158 = (((_e3145 * _e3145) + (_e3146 * _e3146)) + (_e3147 * _e3147));
let _e3162 = (1f / sqrt(select(0f, _e3158, (_e3158 > 0f))));
let _e3163 = (_e3145 * _e3162);
let _e3164 = (_e3146 * _e3162);
let _e3165 = (_e3147 * _e3162);
let _e3166 = (_e192 - select(_e2995.member, (_e2995.member + _e3139), _e2982));
let _e3167 = (_e204 - select(_e2995.member_1, (_e2995.member_1 + _e3140), _e2982));
let _e3168 = (_e217 - select(_e2995.member_2, (_e2995.member_2 + _e3141), _e2982));
let _e3173 = (((_e3166 * _e3163) + (_e3167 * _e3164)) + (_e3168 * _e3165));
let _e3178 = (((_e3166 * _e230) + (_e3167 * _e243)) + (_e3168 * _e256));
let _e3183 = (((_e3163 * _e230) + (_e3164 * _e243)) + (_e3165 * _e256));
let _e3186 = ((_e3164 * _e256) - (_e3165 * _e243));
let _e3189 = ((_e3165 * _e230) - (_e3163 * _e256));
let _e3192 = ((_e3163 * _e243) - (_e3164 * _e230));
let _e3197 = (((_e3186 * _e3186) + (_e3189 * _e3189)) + (_e3192 * _e3192));
let _e3200 = (1f / select(1e-9f, _e3197, (_e3197 > 1e-9f)));
let _e3203 = ((_e3173 - (_e3183 * _e3178)) * _e3200);
let _e3206 = (((_e3183 * _e3173) - _e3178) * _e3200);
let _e3212 = select(0f, _e3203, (((_e3206 >= 0f) && (_e3206 < _e464)) && (_e3203 > 0f)));
let _e3214 = (_e3085 << bitcast<u32>(_e2813));
if (_e3214 < _e904) {
phi_6843_ = _e1073;
} else {
phi_6843_ = select(_e996, _e1150, (_e3214 >= _e905));
}
let _e3219 = phi_6843_;
let _e3227 = (_e2873 + 1i);
if _e2883 {
phi_6867_ = (_e2831 - 1i);
} else {
phi_6867_ = _e2882;
}
let _e3231 = phi_6867_;
let _e3233 = select(_e3227, 0i, (_e3227 < 0i));
let _e3234 = (_e3233 >= _e2829);
if _e3234 {
phi_6878_ = (_e2829 - 1i);
} else {
phi_6878_ = _e3233;
}
let _e3237 = phi_6878_;
let _e3241 = (((f32(_e3231) + 0.5f) * _e2834) - 0.5f);
let _e3245 = (((f32(_e3237) + 0.5f) * _e2834) - 0.5f);
if _e2812 {
phi_6954_ = 0u;
} else {
if (_e2811 == 1u) {
phi_6953_ = 0u;
} else {
if (_e2811 == 2u) {
phi_6952_ = _e2911;
} else {
phi_6952_ = select(_e2917, _e2914, (_e2811 == 3u));
}
let _e3255 = phi_6952_;
phi_6953_ = _e3255;
}
let _e3257 = phi_6953_;
phi_6954_ = _e3257;
}
let _e3259 = phi_6954_;
local_10 = (((bitcast<i32>(_e3259) + select(_e3237, _e3231, _e705)) * _e2908) + select(_e3231, _e3237, _e705));
let _e3264 = local_10;
let _e3266 = select(_e2934, _e3264, (_e3264 < _e2934));
let _e3271 = global_4.member[bitcast<u32>(select(0i, _e3266, (_e3266 > 0i)))];
let _e3276 = (((((select(_e3241, _e3245, _e705) + 0.5f) / _e2942) * 2f) - 1f) * _e2950);
let _e3281 = ((1f - (((select(_e3245, _e3241, _e705) + 0.5f) / _e2943) * 2f)) * _e2958);
let _e3288 = ((_e2961.member * _e3276) + (_e2969.member * _e3281));
let _e3289 = ((_e2961.member_1 * _e3276) + (_e2969.member_1 * _e3281));
let _e3290 = ((_e2961.member_2 * _e3276) + (_e2969.member_2 * _e3281));
let _e3294 = select((_e2984.member + _e3288), _e2984.member, _e2982);
let _e3295 = select((_e2984.member_1 + _e3289), _e2984.member_1, _e2982);
let _e3296 = select((_e2984.member_2 + _e3290), _e2984.member_2, _e2982);
let _e3307 = (((_e3294 * _e3294) + (_e3295 * _e3295)) + (_e3296 * _e3296));
let _e3311 = (1f / sqrt(select(0f, _e3307, (_e3307 > 0f))));
let _e3312 = (_e3294 * _e3311);
let _e3313 = (_e3295 * _e3311);
let _e3314 = (_e3296 * _e3311);
let _e3315 = (_e192 - select(_e2995.member, (_e2995.member + _e3288), _e2982));
let _e3316 = (_e204 - select(_e2995.member_1, (_e2995.member_1 + _e3289), _e2982));
let _e3317 = (_e217 - select(_e2995.member_2, (_e2995.member_2 + _e3290), _e2982));
let _e3322 = (((_e3315 * _e3312) + (_e3316 * _e3313)) + (_e3317 * _e3314));
let _e3327 = (((_e3315 * _e230) + (_e3316 * _e243)) + (_e3317 * _e256));
let _e3332 = (((_e3312 * _e230) + (_e3313 * _e243)) + (_e3314 * _e256));
let _e3335 = ((_e3313 * _e256) - (_e3314 * _e243));
let _e3338 = ((_e3314 * _e230) - (_e3312 * _e256));
let _e3341 = ((_e3312 * _e243) - (_e3313 * _e230));
let _e3346 = (((_e3335 * _e3335) + (_e3338 * _e3338)) + (_e3341 * _e3341));
let _e3349 = (1f / select(1e-9f, _e3346, (_e3346 > 1e-9f)));
let _e3352 = ((_e3322 - (_e3332 * _e3327)) * _e3349);
let _e3355 = (((_e3332 * _e3322) - _e3327) * _e3349);
let _e3361 = select(0f, _e3352, (((_e3355 >= 0f) && (_e3355 < _e464)) && (_e3352 > 0f)));
let _e3363 = (_e3231 << bitcast<u32>(_e2813));
if (_e3363 < _e904) {
phi_7347_ = _e1073;
} else {
phi_7347_ = select(_e996, _e1150, (_e3363 >= _e905));
}
let _e3368 = phi_7347_;
if _e3082 {
phi_7371_ = (_e2831 - 1i);
} else {
phi_7371_ = _e3081;
}
let _e3379 = phi_7371_;
if _e3234 {
phi_7382_ = (_e2829 - 1i);
} else {
phi_7382_ = _e3233;
}
let _e3382 = phi_7382_;
let _e3386 = (((f32(_e3379) + 0.5f) * _e2834) - 0.5f);
let _e3390 = (((f32(_e3382) + 0.5f) * _e2834) - 0.5f);
if _e2812 {
phi_7458_ = 0u;
} else {
if (_e2811 == 1u) {
phi_7457_ = 0u;
} else {
if (_e2811 == 2u) {
phi_7456_ = _e2911;
} else {
phi_7456_ = select(_e2917, _e2914, (_e2811 == 3u));
}
let _e3400 = phi_7456_;
phi_7457_ = _e3400;
}
let _e3402 = phi_7457_;
phi_7458_ = _e3402;
}
let _e3404 = phi_7458_;
local_8 = (((bitcast<i32>(_e3404) + select(_e3382, _e3379, _e705)) * _e2908) + select(_e3379, _e3382, _e705));
let _e3409 = local_8;
let _e3411 = select(_e2934, _e3409, (_e3409 < _e2934));
let _e3416 = global_4.member[bitcast<u32>(select(0i, _e3411, (_e3411 > 0i)))];
let _e3421 = (((((select(_e3386, _e3390, _e705) + 0.5f) / _e2942) * 2f) - 1f) * _e2950);
let _e3426 = ((1f - (((select(_e3390, _e3386, _e705) + 0.5f) / _e2943) * 2f)) * _e2958);
let _e3433 = ((_e2961.member * _e3421) + (_e2969.member * _e3426));
let _e3434 = ((_e2961.member_1 * _e3421) + (_e2969.member_1 * _e3426));
let _e3435 = ((_e2961.member_2 * _e3421) + (_e2969.member_2 * _e3426));
let _e3439 = select((_e2984.member + _e3433), _e2984.member, _e2982);
let _e3440 = select((_e2984.member_1 + _e3434), _e2984.member_1, _e2982);
let _e3441 = select((_e2984.member_2 + _e3435), _e2984.member_2, _e2982);
let _e3452 = (((_e3439 * _e3439) + (_e3440 * _e3440)) + (_e3441 * _e3441));
let _e3456 = (1f / sqrt(select(0f, _e3452, (_e3452 > 0f))));
let _e3457 = (_e3439 * _e3456);
let _e3458 = (_e3440 * _e3456);
let _e3459 = (_e3441 * _e3456);
let _e3460 = (_e192 - select(_e2995.member, (_e2995.member + _e3433), _e2982));
let _e3461 = (_e204 - select(_e2995.member_1, (_e2995.member_1 + _e3434), _e2982));
let _e3462 = (_e217 - select(_e2995.member_2, (_e2995.member_2 + _e3435), _e2982));
let _e3467 = (((_e3460 * _e3457) + (_e3461 * _e3458)) + (_e3462 * _e3459));
let _e3472 = (((_e3460 * _e230) + (_e3461 * _e243)) + (_e3462 * _e256));
let _e3477 = (((_e3457 * _e230) + (_e3458 * _e243)) + (_e3459 * _e256));
let _e3480 = ((_e3458 * _e256) - (_e3459 * _e243));
let _e3483 = ((_e3459 * _e230) - (_e3457 * _e256));
let _e3486 = ((_e3457 * _e243) - (_e3458 * _e230));
let _e3491 = (((_e3480 * _e3480) + (_e3483 * _e3483)) + (_e3486 * _e3486));
let _e3494 = (1f / select(1e-9f, _e3491, (_e3491 > 1e-9f)));
let _e3497 = ((_e3467 - (_e3477 * _e3472)) * _e3494);
let _e3500 = (((_e3477 * _e3467) - _e3472) * _e3494);
let _e3506 = select(0f, _e3497, (((_e3500 >= 0f) && (_e3500 < _e464)) && (_e3497 > 0f)));
let _e3508 = (_e3379 << bitcast<u32>(_e2813));
if (_e3508 < _e904) {
phi_7851_ = _e1073;
} else {
phi_7851_ = select(_e996, _e1150, (_e3508 >= _e905));
}
let _e3513 = phi_7851_;
phi_7862_ = ((((_e2809 - select(0f, (_e2878 * _e2879), (((_e3070 == _e2811) && (_e3063 > 0f)) && (_e3063 < _e2941)))) - select(0f, (_e2875 * _e2879), (((_e3219 == _e2811) && (_e3212 > 0f)) && (_e3212 < _e3122)))) - select(0f, (_e2878 * _e2877), (((_e3368 == _e2811) && (_e3361 > 0f)) && (_e3361 < _e3271)))) - select(0f, (_e2875 * _e2877), (((_e3513 == _e2811) && (_e3506 > 0f)) && (_e3506 < _e3416))));
}
let _e3522 = phi_7862_;
let _e3526 = select(_e1150, 0u, ((_e1150 == _e996) || (_e1150 == _e1073)));
let _e3527 = (_e3526 == 0u);
if _e3527 {
phi_9980_ = _e3522;
} else {
let _e3528 = (_e3526 & 31u);
let _e3530 = (1u << bitcast<u32>(_e3528));
let _e3534 = (((_e2057 + _e3530) - 1u) >> bitcast<u32>(_e3528));
let _e3538 = (((_e2061 + _e3530) - 1u) >> bitcast<u32>(_e3528));
if _e705 {
phi_7900_ = bitcast<i32>(_e3534);
phi_7901_ = bitcast<i32>(_e3538);
} else {
phi_7900_ = bitcast<i32>(_e3538);
phi_7901_ = bitcast<i32>(_e3534);
}
let _e3544 = phi_7900_;
let _e3546 = phi_7901_;
let _e3549 = f32((1i << bitcast<u32>(_e3528)));
let _e3550 = (1f / _e3549);
let _e3554 = (((f32(_e2067) + 0.5f) * _e3550) - 0.5f);
let _e3558 = (((f32(_e2098) + 0.5f) * _e3550) - 0.5f);
let _e3560 = select(-1f, _e3554, (_e3554 > -1f));
let _e3562 = select(1e6f, _e3560, (_e3560 < 1e6f));
let _e3569 = select(0i, select(select(i32(_e3562), i32(-2147483648), (_e3562 < -2147483600f)), 2147483647i, (_e3562 > 2147483500f)), (_e3562 == _e3562));
let _e3573 = (_e3569 - select(0i, 1i, (_e3562 < f32(_e3569))));
let _e3575 = select(-1f, _e3558, (_e3558 > -1f));
let _e3577 = select(1e6f, _e3575, (_e3575 < 1e6f));
let _e3584 = select(0i, select(select(i32(_e3577), i32(-2147483648), (_e3577 < -2147483600f)), 2147483647i, (_e3577 > 2147483500f)), (_e3577 == _e3577));
let _e3588 = (_e3584 - select(0i, 1i, (_e3577 < f32(_e3584))));
let _e3590 = (_e3554 - f32(_e3573));
let _e3592 = (_e3558 - f32(_e3588));
let _e3593 = (1f - _e3590);
let _e3594 = (1f - _e3592);
let _e3597 = select(_e3573, 0i, (_e3573 < 0i));
let _e3598 = (_e3597 >= _e3546);
if _e3598 {
phi_7977_ = (_e3546 - 1i);
} else {
phi_7977_ = _e3597;
}
let _e3601 = phi_7977_;
let _e3603 = select(_e3588, 0i, (_e3588 < 0i));
let _e3604 = (_e3603 >= _e3544);
if _e3604 {
phi_7988_ = (_e3544 - 1i);
} else {
phi_7988_ = _e3603;
}
let _e3607 = phi_7988_;
let _e3611 = (((f32(_e3601) + 0.5f) * _e3549) - 0.5f);
let _e3615 = (((f32(_e3607) + 0.5f) * _e3549) - 0.5f);
let _e3623 = bitcast<i32>(((_e2057 + 1u) >> bitcast<u32>(1u)));
let _e3626 = global_1.member.member_18.member_6;
let _e3629 = global_1.member.member_18.member_7;
let _e3632 = global_1.member.member_18.member_8;
if _e3527 {
phi_8064_ = 0u;
} else {
if (_e3526 == 1u) {
phi_8063_ = 0u;
} else {
if (_e3526 == 2u) {
phi_8062_ = _e3626;
} else {
phi_8062_ = select(_e3632, _e3629, (_e3526 == 3u));
}
let _e3638 = phi_8062_;
phi_8063_ = _e3638;
}
let _e3640 = phi_8063_;
phi_8064_ = _e3640;
}
let _e3642 = phi_8064_;
local_6 = (((bitcast<i32>(_e3642) + select(_e3607, _e3601, _e705)) * _e3623) + select(_e3601, _e3607, _e705));
let _e3647 = local_6;
let _e3649 = (bitcast<i32>(_e111) - 1i);
let _e3651 = select(_e3649, _e3647, (_e3647 < _e3649));
let _e3656 = global_4.member[bitcast<u32>(select(0i, _e3651, (_e3651 > 0i)))];
let _e3657 = f32(_e2058);
let _e3658 = f32(_e2062);
let _e3665 = global_1.member.member_2.member;
let _e3666 = (((((select(_e3611, _e3615, _e705) + 0.5f) / _e3657) * 2f) - 1f) * _e3665);
let _e3673 = global_1.member.member_2.member_1;
let _e3674 = ((1f - (((select(_e3615, _e3611, _e705) + 0.5f) / _e3658) * 2f)) * _e3673);
let _e3676 = global_1.member.member_3;
let _e3684 = global_1.member.member_4;
let _e3691 = ((_e3676.member * _e3666) + (_e3684.member * _e3674));
let _e3692 = ((_e3676.member_1 * _e3666) + (_e3684.member_1 * _e3674));
let _e3693 = ((_e3676.member_2 * _e3666) + (_e3684.member_2 * _e3674));
let _e3696 = global_1.member.member_2.member_3;
let _e3697 = (_e3696 != 0u);
let _e3699 = global_1.member.member_5;
let _e3706 = select((_e3699.member + _e3691), _e3699.member, _e3697);
let _e3707 = select((_e3699.member_1 + _e3692), _e3699.member_1, _e3697);
let _e3708 = select((_e3699.member_2 + _e3693), _e3699.member_2, _e3697);
let _e3710 = global_1.member.member_6;
let _e3724 = (((_e3706 * _e3706) + (_e3707 * _e3707)) + (_e3708 * _e3708));
let _e3728 = (1f / sqrt(select(0f, _e3724, (_e3724 > 0f))));
let _e3729 = (_e3706 * _e3728);
let _e3730 = (_e3707 * _e3728);
let _e3731 = (_e3708 * _e3728);
let _e3732 = (_e192 - select(_e3710.member, (_e3710.member + _e3691), _e3697));
let _e3733 = (_e204 - select(_e3710.member_1, (_e3710.member_1 + _e3692), _e3697));
let _e3734 = (_e217 - select(_e3710.member_2, (_e3710.member_2 + _e3693), _e3697));
let _e3739 = (((_e3732 * _e3729) + (_e3733 * _e3730)) + (_e3734 * _e3731));
let _e3744 = (((_e3732 * _e230) + (_e3733 * _e243)) + (_e3734 * _e256));
let _e3749 = (((_e3729 * _e230) + (_e3730 * _e243)) + (_e3731 * _e256));
let _e3752 = ((_e3730 * _e256) - (_e3731 * _e243));
let _e3755 = ((_e3731 * _e230) - (_e3729 * _e256));
let _e3758 = ((_e3729 * _e243) - (_e3730 * _e230));
let _e3763 = (((_e3752 * _e3752) + (_e3755 * _e3755)) + (_e3758 * _e3758));
let _e3766 = (1f / select(1e-9f, _e3763, (_e3763 > 1e-9f)));
let _e3769 = ((_e3739 - (_e3749 * _e3744)) * _e3766);
let _e3772 = (((_e3749 * _e3739) - _e3744) * _e3766);
let _e3778 = select(0f, _e3769, (((_e3772 >= 0f) && (_e3772 < _e464)) && (_e3769 > 0f)));
let _e3780 = (_e3601 << bitcast<u32>(_e3528));
if (_e3780 < _e904) {
phi_8457_ = _e1073;
} else {
phi_8457_ = select(_e996, _e1150, (_e3780 >= _e905));
}
let _e3785 = phi_8457_;
let _e3793 = (_e3573 + 1i);
let _e3796 = select(_e3793, 0i, (_e3793 < 0i));
let _e3797 = (_e3796 >= _e3546);
if _e3797 {
phi_8481_ = (_e3546 - 1i);
} else {
phi_8481_ = _e3796;
}
let _e3800 = phi_8481_;
if _e3604 {
phi_8492_ = (_e3544 - 1i);
} else {
phi_8492_ = _e3603;
}
let _e3803 = phi_8492_;
let _e3807 = (((f32(_e3800) + 0.5f) * _e3549) - 0.5f);
let _e3811 = (((f32(_e3803) + 0.5f) * _e3549) - 0.5f);
if _e3527 {
phi_8568_ = 0u;
} else {
if (_e3526 == 1u) {
phi_8567_ = 0u;
} else {
if (_e3526 == 2u) {
phi_8566_ = _e3626;
} else {
phi_8566_ = select(_e3632, _e3629, (_e3526 == 3u));
}
let _e3821 = phi_8566_;
phi_8567_ = _e3821;
}
let _e3823 = phi_8567_;
phi_8568_ = _e3823;
}
let _e3825 = phi_8568_;
local_4 = (((bitcast<i32>(_e3825) + select(_e3803, _e3800, _e705)) * _e3623) + select(_e3800, _e3803, _e705));
let _e3830 = local_4;
let _e3832 = select(_e3649, _e3830, (_e3830 < _e3649));
let _e3837 = global_4.member[bitcast<u32>(select(0i, _e3832, (_e3832 > 0i)))];
let _e3842 = (((((select(_e3807, _e3811, _e705) + 0.5f) / _e3657) * 2f) - 1f) * _e3665);
let _e3847 = ((1f - (((select(_e3811, _e3807, _e705) + 0.5f) / _e3658) * 2f)) * _e3673);
let _e3854 = ((_e3676.member * _e3842) + (_e3684.member * _e3847));
let _e3855 = ((_e3676.member_1 * _e3842) + (_e3684.member_1 * _e3847));
let _e3856 = ((_e3676.member_2 * _e3842) + (_e3684.member_2 * _e3847));
let _e3860 = select((_e3699.member + _e3854), _e3699.member, _e3697);
let _e3861 = select((_e3699.member_1 + _e3855), _e3699.member_1, _e3697);
let _e3862 = select((_e3699.member_2 + _e3856), _e3699.member_2, _e3697);
let _e3873 = (((_e3860 * _e3860) + (_e3861 * _e3861)) + (_e3862 * _e3862));
let _e3877 = (1f / sqrt(select(0f, _e3873, (_e3873 > 0f))));
let _e3878 = (_e3860 * _e3877);
let _e3879 = (_e3861 * _e3877);
let _e3880 = (_e3862 * _e3877);
let _e3881 = (_e192 - select(_e3710.member, (_e3710.member + _e3854), _e3697));
let _e3882 = (_e204 - select(_e3710.member_1, (_e3710.member_1 + _e3855), _e3697));
let _e3883 = (_e217 - select(_e3710.member_2, (_e3710.member_2 + _e3856), _e3697));
let _e3888 = (((_e3881 * _e3878) + (_e3882 * _e3879)) + (_e3883 * _e3880));
let _e3893 = (((_e3881 * _e230) + (_e3882 * _e243)) + (_e3883 * _e256));
let _e3898 = (((_e3878 * _e230) + (_e3879 * _e243)) + (_e3880 * _e256));
let _e3901 = ((_e3879 * _e256) - (_e3880 * _e243));
let _e3904 = ((_e3880 * _e230) - (_e3878 * _e256));
let _e3907 = ((_e3878 * _e243) - (_e3879 * _e230));
let _e3912 = (((_e3901 * _e3901) + (_e3904 * _e3904)) + (_e3907 * _e3907));
let _e3915 = (1f / select(1e-9f, _e3912, (_e3912 > 1e-9f)));
let _e3918 = ((_e3888 - (_e3898 * _e3893)) * _e3915);
let _e3921 = (((_e3898 * _e3888) - _e3893) * _e3915);
let _e3927 = select(0f, _e3918, (((_e3921 >= 0f) && (_e3921 < _e464)) && (_e3918 > 0f)));
let _e3929 = (_e3800 << bitcast<u32>(_e3528));
if (_e3929 < _e904) {
phi_8961_ = _e1073;
} else {
phi_8961_ = select(_e996, _e1150, (_e3929 >= _e905));
}
let _e3934 = phi_8961_;
let _e3942 = (_e3588 + 1i);
if _e3598 {
phi_8985_ = (_e3546 - 1i);
} else {
phi_8985_ = _e3597;
}
let _e3946 = phi_8985_;
let _e3948 = select(_e3942, 0i, (_e3942 < 0i));
let _e3949 = (_e3948 >= _e3544);
if _e3949 {
phi_8996_ = (_e3544 - 1i);
} else {
phi_8996_ = _e3948;
}
let _e3952 = phi_8996_;
let _e3956 = (((f32(_e3946) + 0.5f) * _e3549) - 0.5f);
let _e3960 = (((f32(_e3952) + 0.5f) * _e3549) - 0.5f);
if _e3527 {
phi_9072_ = 0u;
} else {
if (_e3526 == 1u) {
phi_9071_ = 0u;
} else {
if (_e3526 == 2u) {
phi_9070_ = _e3626;
} else {
phi_9070_ = select(_e3632, _e3629, (_e3526 == 3u));
}
let _e3970 = phi_9070_;
phi_9071_ = _e3970;
}
let _e3972 = phi_9071_;
phi_9072_ = _e3972;
}
let _e3974 = phi_9072_;
local_2 = (((bitcast<i32>(_e3974) + select(_e3952, _e3946, _e705)) * _e3623) + select(_e3946, _e3952, _e705));
let _e3979 = local_2;
let _e3981 = select(_e3649, _e3979, (_e3979 < _e3649));
let _e3986 = global_4.member[bitcast<u32>(select(0i, _e3981, (_e3981 > 0i)))];
let _e3991 = (((((select(_e3956, _e3960, _e705) + 0.5f) / _e3657) * 2f) - 1f) * _e3665);
let _e3996 = ((1f - (((select(_e3960, _e3956, _e705) + 0.5f) / _e3658) * 2f)) * _e3673);
let _e4003 = ((_e3676.member * _e3991) + (_e3684.member * _e3996));
let _e4004 = ((_e3676.member_1 * _e3991) + (_e3684.member_1 * _e3996));
let _e4005 = ((_e3676.member_2 * _e3991) + (_e3684.member_2 * _e3996));
let _e4009 = select((_e3699.member + _e4003), _e3699.member, _e3697);
let _e4010 = select((_e3699.member_1 + _e4004), _e3699.member_1, _e3697);
let _e4011 = select((_e3699.member_2 + _e4005), _e3699.member_2, _e3697);
let _e4022 = (((_e4009 * _e4009) + (_e4010 * _e4010)) + (_e4011 * _e4011));
let _e4026 = (1f / sqrt(select(0f, _e4022, (_e4022 > 0f))));
let _e4027 = (_e4009 * _e4026);
let _e4028 = (_e4010 * _e4026);
let _e4029 = (_e4011 * _e4026);
let _e4030 = (_e192 - select(_e3710.member, (_e3710.member + _e4003), _e3697));
let _e4031 = (_e204 - select(_e3710.member_1, (_e3710.member_1 + _e4004), _e3697));
let _e4032 = (_e217 - select(_e3710.member_2, (_e3710.member_2 + _e4005), _e3697));
let _e4037 = (((_e4030 * _e4027) + (_e4031 * _e4028)) + (_e4032 * _e4029));
let _e4042 = (((_e4030 * _e230) + (_e4031 * _e243)) + (_e4032 * _e256));
let _e4047 = (((_e4027 * _e230) + (_e4028 * _e243)) + (_e4029 * _e256));
let _e4050 = ((_e4028 * _e256) - (_e4029 * _e243));
let _e4053 = ((_e4029 * _e230) - (_e4027 * _e256));
let _e4056 = ((_e4027 * _e243) - (_e4028 * _e230));
let _e4061 = (((_e4050 * _e4050) + (_e4053 * _e4053)) + (_e4056 * _e4056));
let _e4064 = (1f / select(1e-9f, _e4061, (_e4061 > 1e-9f)));
let _e4067 = ((_e4037 - (_e4047 * _e4042)) * _e4064);
let _e4070 = (((_e4047 * _e4037) - _e4042) * _e4064);
let _e4076 = select(0f, _e4067, (((_e4070 >= 0f) && (_e4070 < _e464)) && (_e4067 > 0f)));
let _e4078 = (_e3946 << bitcast<u32>(_e3528));
if (_e4078 < _e904) {
phi_9465_ = _e1073;
} else {
phi_9465_ = select(_e996, _e1150, (_e4078 >= _e905));
}
let _e4083 = phi_9465_;
if _e3797 {
phi_9489_ = (_e3546 - 1i);
} else {
phi_9489_ = _e3796;
}
let _e4094 = phi_9489_;
if _e3949 {
phi_9500_ = (_e3544 - 1i);
} else {
phi_9500_ = _e3948;
}
let _e4097 = phi_9500_;
let _e4101 = (((f32(_e4094) + 0.5f) * _e3549) - 0.5f);
let _e4105 = (((f32(_e4097) + 0.5f) * _e3549) - 0.5f);
if _e3527 {
phi_9576_ = 0u;
} else {
if (_e3526 == 1u) {
phi_9575_ = 0u;
} else {
if (_e3526 == 2u) {
phi_9574_ = _e3626;
} else {
phi_9574_ = select(_e3632, _e3629, (_e3526 == 3u));
}
let _e4115 = phi_9574_;
phi_9575_ = _e4115;
}
let _e4117 = phi_9575_;
phi_9576_ = _e4117;
}
let _e4119 = phi_9576_;
local = (((bitcast<i32>(_e4119) + select(_e4097, _e4094, _e705)) * _e3623) + select(_e4094, _e4097, _e705));
let _e4124 = local;
let _e4126 = select(_e3649, _e4124, (_e4124 < _e3649));
let _e4131 = global_4.member[bitcast<u32>(select(0i, _e4126, (_e4126 > 0i)))];
let _e4136 = (((((select(_e4101, _e4105, _e705) + 0.5f) / _e3657) * 2f) - 1f) * _e3665);
let _e4141 = ((1f - (((select(_e4105, _e4101, _e705) + 0.5f) / _e3658) * 2f)) * _e3673);
let _e4148 = ((_e3676.member * _e4136) + (_e3684.member * _e4141));
let _e4149 = ((_e3676.member_1 * _e4136) + (_e3684.member_1 * _e4141));
let _e4150 = ((_e3676.member_2 * _e4136) + (_e3684.member_2 * _e4141));
let _e4154 = select((_e3699.member + _e4148), _e3699.member, _e3697);
let _e4155 = select((_e3699.member_1 + _e4149), _e3699.member_1, _e3697);
let _e4156 = select((_e3699.member_2 + _e4150), _e3699.member_2, _e3697);
let _e4167 = (((_e4154 * _e4154) + (_e4155 * _e4155)) + (_e4156 * _e4156));
let _e4171 = (1f / sqrt(select(0f, _e4167, (_e4167 > 0f))));
let _e4172 = (_e4154 * _e4171);
let _e4173 = (_e4155 * _e4171);
let _e4174 = (_e4156 * _e4171);
let _e4175 = (_e192 - select(_e3710.member, (_e3710.member + _e4148), _e3697));
let _e4176 = (_e204 - select(_e3710.member_1, (_e3710.member_1 + _e4149), _e3697));
let _e4177 = (_e217 - select(_e3710.member_2, (_e3710.member_2 + _e4150), _e3697));
let _e4182 = (((_e4175 * _e4172) + (_e4176 * _e4173)) + (_e4177 * _e4174));
let _e4187 = (((_e4175 * _e230) + (_e4176 * _e243)) + (_e4177 * _e256));
let _e4192 = (((_e4172 * _e230) + (_e4173 * _e243)) + (_e4174 * _e256));
let _e4195 = ((_e4173 * _e256) - (_e4174 * _e243));
let _e4198 = ((_e4174 * _e230) - (_e4172 * _e256));
let _e4201 = ((_e4172 * _e243) - (_e4173 * _e230));
let _e4206 = (((_e4195 * _e4195) + (_e4198 * _e4198)) + (_e4201 * _e4201));
let _e4209 = (1f / select(1e-9f, _e4206, (_e4206 > 1e-9f)));
let _e4212 = ((_e4182 - (_e4192 * _e4187)) * _e4209);
let _e4215 = (((_e4192 * _e4182) - _e4187) * _e4209);
let _e4221 = select(0f, _e4212, (((_e4215 >= 0f) && (_e4215 < _e464)) && (_e4212 > 0f)));
let _e4223 = (_e4094 << bitcast<u32>(_e3528));
if (_e4223 < _e904) {
phi_9969_ = _e1073;
} else {
phi_9969_ = select(_e996, _e1150, (_e4223 >= _e905));
}
let _e4228 = phi_9969_;
phi_9980_ = ((((_e3522 - select(0f, (_e3593 * _e3594), (((_e3785 == _e3526) && (_e3778 > 0f)) && (_e3778 < _e3656)))) - select(0f, (_e3590 * _e3594), (((_e3934 == _e3526) && (_e3927 > 0f)) && (_e3927 < _e3837)))) - select(0f, (_e3593 * _e3592), (((_e4083 == _e3526) && (_e4076 > 0f)) && (_e4076 < _e3986)))) - select(0f, (_e3590 * _e3592), (((_e4228 == _e3526) && (_e4221 > 0f)) && (_e4221 < _e4131))));
}
let _e4237 = phi_9980_;
phi_9981_ = _e4237;
} else {
phi_9981_ = 1f;
}
let _e4239 = phi_9981_;
if (_e2073 || (bitcast<f32>((bitcast<u32>(_e4239) & 2147483647u)) > 1e-6f)) {
let _e4245 = select(_e2067, _e2098, _e705);
let _e4246 = select(_e2098, _e2067, _e705);
let _e4250 = ((_e4246 * _e2058) + _e4245);
let _e4252 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e4254 = select(_e4252, _e4250, (_e4250 < _e4252));
let _e4259 = global_3.member[bitcast<u32>(select(0i, _e4254, (_e4254 > 0i)))];
let _e4260 = (bitcast<i32>((_e2057 * _e2061)) + _e4250);
let _e4262 = select(_e4252, _e4260, (_e4260 < _e4252));
let _e4267 = global_3.member[bitcast<u32>(select(0i, _e4262, (_e4262 > 0i)))];
let _e4278 = global_1.member.member_2.member;
let _e4279 = (((((f32(_e4245) + 0.5f) / f32(_e2058)) * 2f) - 1f) * _e4278);
let _e4286 = global_1.member.member_2.member_1;
let _e4287 = ((1f - (((f32(_e4246) + 0.5f) / f32(_e2062)) * 2f)) * _e4286);
let _e4289 = global_1.member.member_3;
let _e4297 = global_1.member.member_4;
let _e4304 = ((_e4289.member * _e4279) + (_e4297.member * _e4287));
let _e4305 = ((_e4289.member_1 * _e4279) + (_e4297.member_1 * _e4287));
let _e4306 = ((_e4289.member_2 * _e4279) + (_e4297.member_2 * _e4287));
let _e4309 = global_1.member.member_2.member_3;
let _e4310 = (_e4309 != 0u);
let _e4312 = global_1.member.member_5;
let _e4319 = select((_e4312.member + _e4304), _e4312.member, _e4310);
let _e4320 = select((_e4312.member_1 + _e4305), _e4312.member_1, _e4310);
let _e4321 = select((_e4312.member_2 + _e4306), _e4312.member_2, _e4310);
let _e4323 = global_1.member.member_6;
let _e4337 = (((_e4319 * _e4319) + (_e4320 * _e4320)) + (_e4321 * _e4321));
let _e4340 = sqrt(select(0f, _e4337, (_e4337 > 0f)));
let _e4341 = (1f / _e4340);
let _e4342 = (_e4319 * _e4341);
let _e4343 = (_e4320 * _e4341);
let _e4344 = (_e4321 * _e4341);
let _e4345 = (_e192 - select(_e4323.member, (_e4323.member + _e4304), _e4310));
let _e4346 = (_e204 - select(_e4323.member_1, (_e4323.member_1 + _e4305), _e4310));
let _e4347 = (_e217 - select(_e4323.member_2, (_e4323.member_2 + _e4306), _e4310));
let _e4352 = (((_e4345 * _e4342) + (_e4346 * _e4343)) + (_e4347 * _e4344));
let _e4357 = (((_e4345 * _e230) + (_e4346 * _e243)) + (_e4347 * _e256));
let _e4362 = (((_e4342 * _e230) + (_e4343 * _e243)) + (_e4344 * _e256));
let _e4365 = ((_e4343 * _e256) - (_e4344 * _e243));
let _e4368 = ((_e4344 * _e230) - (_e4342 * _e256));
let _e4371 = ((_e4342 * _e243) - (_e4343 * _e230));
let _e4376 = (((_e4365 * _e4365) + (_e4368 * _e4368)) + (_e4371 * _e4371));
let _e4379 = (1f / select(1e-9f, _e4376, (_e4376 > 1e-9f)));
let _e4382 = ((_e4352 - (_e4362 * _e4357)) * _e4379);
let _e4385 = (((_e4362 * _e4352) - _e4357) * _e4379);
let _e4391 = (_e4382 - _e4267);
let _e4394 = (_e4385 + select(0f, _e4391, (_e4391 > 0f)));
let _e4397 = global_1.member.member_13.member;
let _e4402 = -((_e4397.member * _e4394));
let _e4404 = select(-87f, _e4402, (_e4402 > -87f));
let _e4406 = select(88f, _e4404, (_e4404 < 88f));
let _e4408 = ((_e4406 * 1.442695f) + 0.5f);
let _e4410 = select(-127f, _e4408, (_e4408 > -127f));
let _e4412 = select(128f, _e4410, (_e4410 < 128f));
let _e4419 = select(0i, select(select(i32(_e4412), i32(-2147483648), (_e4412 < -2147483600f)), 2147483647i, (_e4412 > 2147483500f)), (_e4412 == _e4412));
let _e4423 = (_e4419 - select(0i, 1i, (_e4412 < f32(_e4419))));
let _e4424 = f32(_e4423);
let _e4428 = ((_e4406 - (_e4424 * 0.6933594f)) - (_e4424 * -2.1219444e-4f));
let _e4450 = -((_e4397.member_1 * _e4394));
let _e4452 = select(-87f, _e4450, (_e4450 > -87f));
let _e4454 = select(88f, _e4452, (_e4452 < 88f));
let _e4456 = ((_e4454 * 1.442695f) + 0.5f);
let _e4458 = select(-127f, _e4456, (_e4456 > -127f));
let _e4460 = select(128f, _e4458, (_e4458 < 128f));
let _e4467 = select(0i, select(select(i32(_e4460), i32(-2147483648), (_e4460 < -2147483600f)), 2147483647i, (_e4460 > 2147483500f)), (_e4460 == _e4460));
let _e4471 = (_e4467 - select(0i, 1i, (_e4460 < f32(_e4467))));
let _e4472 = f32(_e4471);
let _e4476 = ((_e4454 - (_e4472 * 0.6933594f)) - (_e4472 * -2.1219444e-4f));
let _e4498 = -((_e4397.member_2 * _e4394));
let _e4500 = select(-87f, _e4498, (_e4498 > -87f));
let _e4502 = select(88f, _e4500, (_e4500 < 88f));
let _e4504 = ((_e4502 * 1.442695f) + 0.5f);
let _e4506 = select(-127f, _e4504, (_e4504 > -127f));
let _e4508 = select(128f, _e4506, (_e4506 < 128f));
let _e4515 = select(0i, select(select(i32(_e4508), i32(-2147483648), (_e4508 < -2147483600f)), 2147483647i, (_e4508 > 2147483500f)), (_e4508 == _e4508));
let _e4519 = (_e4515 - select(0i, 1i, (_e4508 < f32(_e4515))));
let _e4520 = f32(_e4519);
let _e4524 = ((_e4502 - (_e4520 * 0.6933594f)) - (_e4520 * -2.1219444e-4f));
let _e4545 = -(_e4362);
let _e4548 = global_1.member.member_13.member_2;
let _e4549 = (_e4548 * _e4548);
let _e4553 = ((1f + _e4549) - ((2f * _e4548) * _e4545));
let _e4555 = select(1e-9f, _e4553, (_e4553 > 1e-9f));
let _e4567 = global_1.member.member_13.member_3;
let _e4572 = (_e4340 * (select(((1f - _e4549) / (_e4555 * sqrt(select(0f, _e4555, (_e4555 > 0f))))), (0.75f * (1f + (_e4545 * _e4545))), (_e4567 == 1u)) * (0.25f / 3.1415927f)));
let _e4575 = global_1.member.member_13.member_1;
let _e4588 = select(0f, _e4382, (((_e4385 >= 0f) && (_e4385 < _e464)) && (_e4382 > 0f)));
if ((_e4588 > 0f) && (_e4588 < _e4259)) {
let _e4595 = ((f32(_e2098) - _e2095.member) * _e714);
let _e4598 = (_e714 * 1f);
let _e4599 = (1e-4f * _e4598);
let _e4601 = select(_e2095.member_2, _e2095.member_1, (_e2095.member_1 > _e2095.member_2));
let _e4603 = select(_e4599, _e4601, (_e4601 > _e4599));
let _e4605 = select(_e2095.member_2, _e2095.member_1, (_e2095.member_1 < _e2095.member_2));
let _e4607 = select(_e4599, _e4605, (_e4605 > _e4599));
let _e4608 = (0.5f * _e4598);
let _e4609 = (_e4595 + _e4608);
let _e4610 = -(_e4609);
let _e4614 = (0.5f * (_e4603 + _e4607));
let _e4615 = (_e4614 - select(_e4610, _e4609, (_e4609 > _e4610)));
let _e4617 = select(0f, _e4615, (_e4615 > 0f));
let _e4619 = select(_e4607, _e4617, (_e4617 < _e4607));
let _e4623 = (_e4615 - _e4607);
let _e4627 = ((((_e4619 * (_e4619 / _e4607)) * 0.5f) + select(0f, _e4623, (_e4623 > 0f))) / _e4603);
let _e4631 = (_e4595 - _e4608);
let _e4632 = -(_e4631);
let _e4635 = (_e4614 - select(_e4632, _e4631, (_e4631 > _e4632)));
let _e4637 = select(0f, _e4635, (_e4635 > 0f));
let _e4639 = select(_e4607, _e4637, (_e4637 < _e4607));
let _e4643 = (_e4635 - _e4607);
let _e4647 = ((((_e4639 * (_e4639 / _e4607)) * 0.5f) + select(0f, _e4643, (_e4643 > 0f))) / _e4603);
let _e4653 = (((select(_e4627, (1f - _e4627), (_e4609 >= 0f)) - select(_e4647, (1f - _e4647), (_e4631 >= 0f))) / _e4598) * _e4239);
let _e4657 = (_e4250 * 6i);
let _e4660 = global_1.member.member_18.member;
let _e4661 = (((((_e425 * _e4575.member) * ((1f + (_e4428 * (1f + (_e4428 * (0.5f + (_e4428 * (0.16666667f + (_e4428 * (0.041666668f + (_e4428 * (0.008333334f + (_e4428 * (0.001388889f + (_e4428 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4423 + 127i)) << bitcast<u32>(23i))))) * _e4572) * _e4653) * _e4660);
if (bitcast<f32>((bitcast<u32>(_e4661) & 2147483647u)) < 1073741800f) {
let _e4667 = ((_e4661 * 1f) + 0.5f);
let _e4669 = select(-1073741800f, _e4667, (_e4667 > -1073741800f));
let _e4671 = select(1073741800f, _e4669, (_e4669 < 1073741800f));
let _e4678 = select(0i, select(select(i32(_e4671), i32(-2147483648), (_e4671 < -2147483600f)), 2147483647i, (_e4671 > 2147483500f)), (_e4671 == _e4671));
let _e4682 = (_e4678 - select(0i, 1i, (_e4671 < f32(_e4678))));
if (_e4682 == 0i) {
} else {
let _e4684 = bitcast<u32>(_e4682);
let _e4685 = bitcast<u32>(_e4657);
if (_e4685 < _e113) {
let _e4689 = atomicAdd((&global_5.member[_e4685]), _e4684);
phi_10709_ = _e4689;
} else {
phi_10709_ = 0u;
}
let _e4691 = phi_10709_;
let _e4698 = (bitcast<u32>((_e4682 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e4691 + _e4684) < _e4684)));
if (_e4698 == 0u) {
} else {
let _e4700 = (_e4685 + 1u);
if (_e4700 < _e113) {
let _e4704 = atomicAdd((&global_5.member[_e4700]), _e4698);
}
}
}
} else {
let _e4707 = ((_e4661 * (1f / 1048576f)) + 0.5f);
let _e4709 = select(-1073741800f, _e4707, (_e4707 > -1073741800f));
let _e4711 = select(1073741800f, _e4709, (_e4709 < 1073741800f));
let _e4718 = select(0i, select(select(i32(_e4711), i32(-2147483648), (_e4711 < -2147483600f)), 2147483647i, (_e4711 > 2147483500f)), (_e4711 == _e4711));
let _e4722 = (_e4718 - select(0i, 1i, (_e4711 < f32(_e4718))));
let _e4725 = (bitcast<u32>(_e4722) << bitcast<u32>(20i));
let _e4726 = bitcast<u32>(_e4657);
if (_e4726 < _e113) {
let _e4730 = atomicAdd((&global_5.member[_e4726]), _e4725);
phi_10763_ = _e4730;
} else {
phi_10763_ = 0u;
}
let _e4732 = phi_10763_;
let _e4736 = (_e4726 + 1u);
if (_e4736 < _e113) {
let _e4744 = atomicAdd((&global_5.member[_e4736]), (bitcast<u32>((_e4722 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e4732 + _e4725) < _e4725))));
}
}
let _e4745 = (_e4657 + 2i);
let _e4746 = (((((_e438 * _e4575.member_1) * ((1f + (_e4476 * (1f + (_e4476 * (0.5f + (_e4476 * (0.16666667f + (_e4476 * (0.041666668f + (_e4476 * (0.008333334f + (_e4476 * (0.001388889f + (_e4476 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4471 + 127i)) << bitcast<u32>(23i))))) * _e4572) * _e4653) * _e4660);
if (bitcast<f32>((bitcast<u32>(_e4746) & 2147483647u)) < 1073741800f) {
let _e4752 = ((_e4746 * 1f) + 0.5f);
let _e4754 = select(-1073741800f, _e4752, (_e4752 > -1073741800f));
let _e4756 = select(1073741800f, _e4754, (_e4754 < 1073741800f));
let _e4763 = select(0i, select(select(i32(_e4756), i32(-2147483648), (_e4756 < -2147483600f)), 2147483647i, (_e4756 > 2147483500f)), (_e4756 == _e4756));
let _e4767 = (_e4763 - select(0i, 1i, (_e4756 < f32(_e4763))));
if (_e4767 == 0i) {
} else {
let _e4769 = bitcast<u32>(_e4767);
let _e4770 = bitcast<u32>(_e4745);
if (_e4770 < _e113) {
let _e4774 = atomicAdd((&global_5.member[_e4770]), _e4769);
phi_10827_ = _e4774;
} else {
phi_10827_ = 0u;
}
let _e4776 = phi_10827_;
let _e4783 = (bitcast<u32>((_e4767 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e4776 + _e4769) < _e4769)));
if (_e4783 == 0u) {
} else {
let _e4785 = (_e4770 + 1u);
if (_e4785 < _e113) {
let _e4789 = atomicAdd((&global_5.member[_e4785]), _e4783);
}
}
}
} else {
let _e4792 = ((_e4746 * (1f / 1048576f)) + 0.5f);
let _e4794 = select(-1073741800f, _e4792, (_e4792 > -1073741800f));
let _e4796 = select(1073741800f, _e4794, (_e4794 < 1073741800f));
let _e4803 = select(0i, select(select(i32(_e4796), i32(-2147483648), (_e4796 < -2147483600f)), 2147483647i, (_e4796 > 2147483500f)), (_e4796 == _e4796));
let _e4807 = (_e4803 - select(0i, 1i, (_e4796 < f32(_e4803))));
let _e4810 = (bitcast<u32>(_e4807) << bitcast<u32>(20i));
let _e4811 = bitcast<u32>(_e4745);
if (_e4811 < _e113) {
let _e4815 = atomicAdd((&global_5.member[_e4811]), _e4810);
phi_10881_ = _e4815;
} else {
phi_10881_ = 0u;
}
let _e4817 = phi_10881_;
let _e4821 = (_e4811 + 1u);
if (_e4821 < _e113) {
let _e4829 = atomicAdd((&global_5.member[_e4821]), (bitcast<u32>((_e4807 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e4817 + _e4810) < _e4810))));
}
}
let _e4830 = (_e4657 + 4i);
let _e4831 = (((((_e451 * _e4575.member_2) * ((1f + (_e4524 * (1f + (_e4524 * (0.5f + (_e4524 * (0.16666667f + (_e4524 * (0.041666668f + (_e4524 * (0.008333334f + (_e4524 * (0.001388889f + (_e4524 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4519 + 127i)) << bitcast<u32>(23i))))) * _e4572) * _e4653) * _e4660);
if (bitcast<f32>((bitcast<u32>(_e4831) & 2147483647u)) < 1073741800f) {
let _e4837 = ((_e4831 * 1f) + 0.5f);
let _e4839 = select(-1073741800f, _e4837, (_e4837 > -1073741800f));
let _e4841 = select(1073741800f, _e4839, (_e4839 < 1073741800f));
let _e4848 = select(0i, select(select(i32(_e4841), i32(-2147483648), (_e4841 < -2147483600f)), 2147483647i, (_e4841 > 2147483500f)), (_e4841 == _e4841));
let _e4852 = (_e4848 - select(0i, 1i, (_e4841 < f32(_e4848))));
if (_e4852 == 0i) {
} else {
let _e4854 = bitcast<u32>(_e4852);
let _e4855 = bitcast<u32>(_e4830);
if (_e4855 < _e113) {
let _e4859 = atomicAdd((&global_5.member[_e4855]), _e4854);
phi_10945_ = _e4859;
} else {
phi_10945_ = 0u;
}
let _e4861 = phi_10945_;
let _e4868 = (bitcast<u32>((_e4852 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e4861 + _e4854) < _e4854)));
if (_e4868 == 0u) {
} else {
let _e4870 = (_e4855 + 1u);
if (_e4870 < _e113) {
let _e4874 = atomicAdd((&global_5.member[_e4870]), _e4868);
}
}
}
} else {
let _e4877 = ((_e4831 * (1f / 1048576f)) + 0.5f);
let _e4879 = select(-1073741800f, _e4877, (_e4877 > -1073741800f));
let _e4881 = select(1073741800f, _e4879, (_e4879 < 1073741800f));
let _e4888 = select(0i, select(select(i32(_e4881), i32(-2147483648), (_e4881 < -2147483600f)), 2147483647i, (_e4881 > 2147483500f)), (_e4881 == _e4881));
let _e4892 = (_e4888 - select(0i, 1i, (_e4881 < f32(_e4888))));
let _e4895 = (bitcast<u32>(_e4892) << bitcast<u32>(20i));
let _e4896 = bitcast<u32>(_e4830);
if (_e4896 < _e113) {
let _e4900 = atomicAdd((&global_5.member[_e4896]), _e4895);
phi_10999_ = _e4900;
} else {
phi_10999_ = 0u;
}
let _e4902 = phi_10999_;
let _e4906 = (_e4896 + 1u);
if (_e4906 < _e113) {
let _e4914 = atomicAdd((&global_5.member[_e4906]), (bitcast<u32>((_e4892 >> bitcast<u32>(12i))) + select(0u, 1u, ((_e4902 + _e4895) < _e4895))));
}
}
}
}
phi_3618_ = (_e2098 + 1i);
} else {
phi_3618_ = i32();
}
let _e4917 = phi_3618_;
continue;
continuing {
phi_3617_ = _e4917;
break if !(_e2103);
}
}
phi_3569_ = (_e2067 + 1i);
} else {
phi_3569_ = i32();
}
let _e4921 = phi_3569_;
continue;
continuing {
phi_3568_ = _e4921;
break if !(_e2072);
}
}
}
phi_2338_ = (_e1246 + 1i);
} else {
phi_2338_ = i32();
}
let _e4925 = phi_2338_;
continue;
continuing {
phi_2337_ = _e4925;
break if !(_e1247);
}
}
phi_2244_ = (_e1175 + 1i);
} else {
phi_2244_ = i32();
}
let _e4929 = phi_2244_;
continue;
continuing {
phi_2243_ = _e4929;
break if !(_e1176);
}
}
}
}
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
