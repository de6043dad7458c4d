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
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
member_12: u32,
member_13: u32,
member_14: f32,
member_15: f32,
member_16: f32,
}
struct type_19 {
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
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_22 {
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
member_19: type_21,
}
struct type_23 {
member: type_22,
}
struct type_24 {
member: vec3<f32>,
member_1: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_23;
@group(0) @binding(2)
var<storage, read_write> global_2: type_13;
@group(0) @binding(1)
var<storage> global_3: type_13;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var phi_151_: u32;
var phi_152_: u32;
var local_6: u32;
var local_7: u32;
var phi_173_: u32;
var phi_181_: u32;
var phi_182_: u32;
var local_8: u32;
var local_9: u32;
var phi_210_: u32;
var phi_211_: u32;
var local_10: u32;
var local_11: u32;
var local_12: u32;
var local_13: u32;
var phi_275_: u32;
var phi_278_: type_24;
var phi_280_: type_24;
var phi_282_: type_24;
var phi_284_: type_24;
var phi_293_: u32;
var phi_294_: u32;
var local_14: u32;
var local_15: u32;
var phi_311_: u32;
var phi_312_: u32;
var local_16: u32;
var local_17: u32;
var phi_334_: u32;
var phi_335_: u32;
var phi_347_: u32;
var phi_348_: u32;
var local_18: u32;
var local_19: u32;
var local_20: u32;
var phi_375_: u32;
var phi_378_: type_24;
var phi_380_: type_24;
var phi_382_: type_24;
var phi_384_: type_24;
var phi_1509_: type_24;
var phi_1510_: type_24;
var phi_1511_: type_24;
var phi_1512_: type_24;
var phi_1513_: type_24;
var phi_376_: u32;
var phi_379_: type_24;
var phi_381_: type_24;
var phi_383_: type_24;
var phi_385_: type_24;
var phi_276_: u32;
var phi_279_: type_24;
var phi_281_: type_24;
var phi_283_: type_24;
var phi_285_: type_24;
var local_21: type_24;
var local_22: type_24;
var local_23: type_24;
var local_24: type_24;
var local_25: type_24;
var local_26: type_24;
var local_27: type_24;
var local_28: type_24;
var local_29: type_24;
var local_30: type_24;
var local_31: type_24;
var local_32: type_24;
let _e70 = global;
let _e76 = global_1.member.member;
if (_e70.x < _e76.member) {
if (_e70.y < _e76.member_1) {
let _e83 = (_e76.member * _e76.member_1);
let _e85 = ((_e70.y * _e76.member) + _e70.x);
let _e89 = global_1.member.member_11.member;
phi_151_ = 0u;
loop {
let _e91 = phi_151_;
local_6 = _e91;
local_7 = _e91;
let _e95 = ((1u << bitcast<u32>((_e91 & 31u))) < _e89);
if _e95 {
phi_152_ = (_e91 + 1u);
} else {
phi_152_ = u32();
}
let _e98 = phi_152_;
continue;
continuing {
phi_151_ = _e98;
break if !(_e95);
}
}
let _e101 = local_6;
let _e104 = local_7;
let _e109 = global_1.member.member.member;
let _e111 = ((_e70.y * _e109) + _e70.x);
phi_173_ = 0u;
loop {
let _e113 = phi_173_;
let _e115 = (_e113 + 1u);
phi_181_ = 0u;
local_12 = _e113;
local_13 = _e113;
loop {
let _e117 = phi_181_;
local_8 = _e117;
local_9 = _e117;
let _e121 = ((1u << bitcast<u32>((_e117 & 31u))) < _e89);
if _e121 {
phi_182_ = (_e117 + 1u);
} else {
phi_182_ = u32();
}
let _e124 = phi_182_;
continue;
continuing {
phi_181_ = _e124;
break if !(_e121);
}
}
let _e127 = local_8;
let _e133 = local_9;
let _e143 = ((_e113 < select(6u, _e104, (_e101 < 6u))) && (_e111 >= ((((1u << bitcast<u32>(((2u * _e127) & 31u))) - (1u << bitcast<u32>(((2u * (_e133 - _e115)) & 31u)))) / 3u) * 4u)));
continue;
continuing {
phi_173_ = select(u32(), _e115, _e143);
break if !(_e143);
}
}
phi_210_ = 0u;
loop {
let _e147 = phi_210_;
local_10 = _e147;
local_11 = _e147;
let _e151 = ((1u << bitcast<u32>((_e147 & 31u))) < _e89);
if _e151 {
phi_211_ = (_e147 + 1u);
} else {
phi_211_ = u32();
}
let _e154 = phi_211_;
continue;
continuing {
phi_210_ = _e154;
break if !(_e151);
}
}
let _e157 = local_10;
let _e163 = local_11;
let _e165 = local_12;
let _e174 = (_e111 - ((((1u << bitcast<u32>(((2u * _e157) & 31u))) - (1u << bitcast<u32>(((2u * (_e163 - _e165)) & 31u)))) / 3u) * 4u));
let _e175 = (_e174 & 1431655765u);
let _e179 = ((_e175 | (_e175 >> bitcast<u32>(1i))) & 858993459u);
let _e183 = ((_e179 | (_e179 >> bitcast<u32>(2i))) & 252645135u);
let _e187 = ((_e183 | (_e183 >> bitcast<u32>(4i))) & 16711935u);
let _e194 = ((_e174 >> bitcast<u32>(1i)) & 1431655765u);
let _e198 = ((_e194 | (_e194 >> bitcast<u32>(1i))) & 858993459u);
let _e202 = ((_e198 | (_e198 >> bitcast<u32>(2i))) & 252645135u);
let _e206 = ((_e202 | (_e202 >> bitcast<u32>(4i))) & 16711935u);
let _e212 = local_13;
let _e215 = (1u << bitcast<u32>((_e212 & 31u)));
let _e216 = (((_e187 | (_e187 >> bitcast<u32>(8i))) & 65535u) * _e215);
let _e217 = (((_e206 | (_e206 >> bitcast<u32>(8i))) & 65535u) * _e215);
let _e219 = bitcast<i32>((_e89 * _e89));
let _e223 = global_1.member.member_12.member_4;
let _e227 = global_1.member.member_12.member_6;
let _e229 = bitcast<i32>((_e223 * _e227));
phi_275_ = _e217;
phi_278_ = type_24(vec3<f32>(1e30f, 1e30f, 1e30f), vec3<f32>(-1e30f, -1e30f, -1e30f));
phi_280_ = type_24(vec3<f32>(1e30f, 1e30f, 1e30f), vec3<f32>(-1e30f, -1e30f, -1e30f));
phi_282_ = type_24(vec3<f32>(1e30f, 1e30f, 1e30f), vec3<f32>(-1e30f, -1e30f, -1e30f));
phi_284_ = type_24(vec3<f32>(1e30f, 1e30f, 1e30f), vec3<f32>(-1e30f, -1e30f, -1e30f));
loop {
let _e231 = phi_275_;
let _e233 = phi_278_;
let _e235 = phi_280_;
let _e237 = phi_282_;
let _e239 = phi_284_;
phi_293_ = 0u;
local_21 = _e239;
local_22 = _e239;
local_23 = _e237;
local_24 = _e237;
local_25 = _e235;
local_26 = _e235;
local_27 = _e233;
local_28 = _e233;
loop {
let _e245 = phi_293_;
local_14 = _e245;
local_15 = _e245;
let _e249 = ((1u << bitcast<u32>((_e245 & 31u))) < _e89);
if _e249 {
phi_294_ = (_e245 + 1u);
} else {
phi_294_ = u32();
}
let _e252 = phi_294_;
continue;
continuing {
phi_293_ = _e252;
break if !(_e249);
}
}
let _e255 = local_14;
let _e258 = local_15;
phi_311_ = 0u;
loop {
let _e261 = phi_311_;
local_16 = _e261;
local_17 = _e261;
let _e265 = ((1u << bitcast<u32>((_e261 & 31u))) < _e89);
if _e265 {
phi_312_ = (_e261 + 1u);
} else {
phi_312_ = u32();
}
let _e268 = phi_312_;
continue;
continuing {
phi_311_ = _e268;
break if !(_e265);
}
}
let _e271 = local_16;
let _e277 = local_17;
phi_334_ = 0u;
loop {
let _e287 = phi_334_;
local_20 = _e287;
let _e291 = ((1u << bitcast<u32>((_e287 & 31u))) < _e89);
if _e291 {
phi_335_ = (_e287 + 1u);
} else {
phi_335_ = u32();
}
let _e294 = phi_335_;
continue;
continuing {
phi_334_ = _e294;
break if !(_e291);
}
}
phi_347_ = 0u;
loop {
let _e297 = phi_347_;
local_18 = _e297;
local_19 = _e297;
let _e301 = ((1u << bitcast<u32>((_e297 & 31u))) < _e89);
if _e301 {
phi_348_ = (_e297 + 1u);
} else {
phi_348_ = u32();
}
let _e304 = phi_348_;
continue;
continuing {
phi_347_ = _e304;
break if !(_e301);
}
}
let _e307 = local_18;
let _e310 = local_19;
let _e313 = local_20;
let _e321 = (((_e231 < (_e217 + _e215)) && (_e231 < _e89)) && (_e111 < (((((1u << bitcast<u32>(((2u * _e271) & 31u))) - (1u << bitcast<u32>(((2u * (_e277 - select(6u, _e258, (_e255 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e313 - select(6u, _e310, (_e307 < 6u)))) & 31u))))));
if _e321 {
phi_375_ = _e216;
phi_378_ = _e233;
phi_380_ = _e235;
phi_382_ = _e237;
phi_384_ = _e239;
loop {
let _e323 = phi_375_;
let _e325 = phi_378_;
let _e327 = phi_380_;
let _e329 = phi_382_;
let _e331 = phi_384_;
local_29 = _e325;
local_30 = _e327;
local_31 = _e329;
local_32 = _e331;
let _e335 = ((_e323 < (_e216 + _e215)) && (_e323 < _e89));
if _e335 {
let _e338 = bitcast<i32>(((_e231 * _e89) + _e323));
local_3 = _e229;
local_4 = _e338;
local_5 = _e219;
let _e339 = local_3;
let _e340 = local_5;
let _e343 = local_4;
let _e344 = ((_e339 + (18i * _e340)) + _e343);
let _e346 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e348 = select(_e346, _e344, (_e344 < _e346));
let _e353 = global_3.member[bitcast<u32>(select(0i, _e348, (_e348 > 0i)))];
let _e354 = local_3;
let _e355 = local_5;
let _e358 = local_4;
let _e359 = ((_e354 + (19i * _e355)) + _e358);
let _e361 = select(_e346, _e359, (_e359 < _e346));
let _e366 = global_3.member[bitcast<u32>(select(0i, _e361, (_e361 > 0i)))];
let _e368 = local_3;
let _e369 = local_5;
let _e372 = local_4;
let _e373 = ((_e368 + (20i * _e369)) + _e372);
let _e375 = select(_e346, _e373, (_e373 < _e346));
let _e380 = global_3.member[bitcast<u32>(select(0i, _e375, (_e375 > 0i)))];
if (((_e353 + _e366) + _e380) > 0f) {
local = _e229;
local_1 = _e338;
local_2 = _e219;
let _e383 = local;
let _e384 = local_1;
let _e385 = (_e383 + _e384);
let _e387 = select(_e346, _e385, (_e385 < _e346));
let _e392 = global_3.member[bitcast<u32>(select(0i, _e387, (_e387 > 0i)))];
let _e393 = local;
let _e394 = local_2;
let _e396 = local_1;
let _e397 = ((_e393 + _e394) + _e396);
let _e399 = select(_e346, _e397, (_e397 < _e346));
let _e404 = global_3.member[bitcast<u32>(select(0i, _e399, (_e399 > 0i)))];
let _e405 = local;
let _e406 = local_2;
let _e409 = local_1;
let _e410 = ((_e405 + (2i * _e406)) + _e409);
let _e412 = select(_e346, _e410, (_e410 < _e346));
let _e417 = global_3.member[bitcast<u32>(select(0i, _e412, (_e412 > 0i)))];
let _e418 = local;
let _e419 = local_2;
let _e422 = local_1;
let _e423 = ((_e418 + (3i * _e419)) + _e422);
let _e425 = select(_e346, _e423, (_e423 < _e346));
let _e430 = global_3.member[bitcast<u32>(select(0i, _e425, (_e425 > 0i)))];
let _e431 = local;
let _e432 = local_2;
let _e435 = local_1;
let _e436 = ((_e431 + (4i * _e432)) + _e435);
let _e438 = select(_e346, _e436, (_e436 < _e346));
let _e443 = global_3.member[bitcast<u32>(select(0i, _e438, (_e438 > 0i)))];
let _e444 = local;
let _e445 = local_2;
let _e448 = local_1;
let _e449 = ((_e444 + (5i * _e445)) + _e448);
let _e451 = select(_e346, _e449, (_e449 < _e346));
let _e456 = global_3.member[bitcast<u32>(select(0i, _e451, (_e451 > 0i)))];
let _e457 = local;
let _e458 = local_2;
let _e461 = local_1;
let _e462 = ((_e457 + (6i * _e458)) + _e461);
let _e464 = select(_e346, _e462, (_e462 < _e346));
let _e469 = global_3.member[bitcast<u32>(select(0i, _e464, (_e464 > 0i)))];
let _e470 = local;
let _e471 = local_2;
let _e474 = local_1;
let _e475 = ((_e470 + (7i * _e471)) + _e474);
let _e477 = select(_e346, _e475, (_e475 < _e346));
let _e482 = global_3.member[bitcast<u32>(select(0i, _e477, (_e477 > 0i)))];
let _e483 = local;
let _e484 = local_2;
let _e487 = local_1;
let _e488 = ((_e483 + (8i * _e484)) + _e487);
let _e490 = select(_e346, _e488, (_e488 < _e346));
let _e495 = global_3.member[bitcast<u32>(select(0i, _e490, (_e490 > 0i)))];
let _e496 = local;
let _e497 = local_2;
let _e500 = local_1;
let _e501 = ((_e496 + (9i * _e497)) + _e500);
let _e503 = select(_e346, _e501, (_e501 < _e346));
let _e508 = global_3.member[bitcast<u32>(select(0i, _e503, (_e503 > 0i)))];
let _e509 = local;
let _e510 = local_2;
let _e513 = local_1;
let _e514 = ((_e509 + (10i * _e510)) + _e513);
let _e516 = select(_e346, _e514, (_e514 < _e346));
let _e521 = global_3.member[bitcast<u32>(select(0i, _e516, (_e516 > 0i)))];
let _e522 = local;
let _e523 = local_2;
let _e526 = local_1;
let _e527 = ((_e522 + (11i * _e523)) + _e526);
let _e529 = select(_e346, _e527, (_e527 < _e346));
let _e534 = global_3.member[bitcast<u32>(select(0i, _e529, (_e529 > 0i)))];
let _e535 = local;
let _e536 = local_2;
let _e539 = local_1;
let _e540 = ((_e535 + (12i * _e536)) + _e539);
let _e542 = select(_e346, _e540, (_e540 < _e346));
let _e547 = global_3.member[bitcast<u32>(select(0i, _e542, (_e542 > 0i)))];
let _e548 = local;
let _e549 = local_2;
let _e552 = local_1;
let _e553 = ((_e548 + (13i * _e549)) + _e552);
let _e555 = select(_e346, _e553, (_e553 < _e346));
let _e560 = global_3.member[bitcast<u32>(select(0i, _e555, (_e555 > 0i)))];
let _e561 = local;
let _e562 = local_2;
let _e565 = local_1;
let _e566 = ((_e561 + (14i * _e562)) + _e565);
let _e568 = select(_e346, _e566, (_e566 < _e346));
let _e573 = global_3.member[bitcast<u32>(select(0i, _e568, (_e568 > 0i)))];
let _e574 = local;
let _e575 = local_2;
let _e578 = local_1;
let _e579 = ((_e574 + (15i * _e575)) + _e578);
let _e581 = select(_e346, _e579, (_e579 < _e346));
let _e586 = global_3.member[bitcast<u32>(select(0i, _e581, (_e581 > 0i)))];
let _e587 = local;
let _e588 = local_2;
let _e591 = local_1;
let _e592 = ((_e587 + (16i * _e588)) + _e591);
let _e594 = select(_e346, _e592, (_e592 < _e346));
let _e599 = global_3.member[bitcast<u32>(select(0i, _e594, (_e594 > 0i)))];
let _e600 = local;
let _e601 = local_2;
let _e604 = local_1;
let _e605 = ((_e600 + (17i * _e601)) + _e604);
let _e607 = select(_e346, _e605, (_e605 < _e346));
let _e612 = global_3.member[bitcast<u32>(select(0i, _e607, (_e607 > 0i)))];
let _e613 = local;
let _e614 = local_2;
let _e617 = local_1;
let _e618 = ((_e613 + (23i * _e614)) + _e617);
let _e620 = select(_e346, _e618, (_e618 < _e346));
let _e625 = global_3.member[bitcast<u32>(select(0i, _e620, (_e620 > 0i)))];
let _e626 = local;
let _e627 = local_2;
let _e630 = local_1;
let _e631 = ((_e626 + (24i * _e627)) + _e630);
let _e633 = select(_e346, _e631, (_e631 < _e346));
let _e638 = global_3.member[bitcast<u32>(select(0i, _e633, (_e633 > 0i)))];
let _e672 = ((bitcast<f32>((bitcast<u32>((_e469 + (_e547 * 0f))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((_e508 + (_e586 * 0f))) & 2147483647u))) * 0.5f);
let _e673 = ((bitcast<f32>((bitcast<u32>((_e482 + (_e560 * 0f))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((_e521 + (_e599 * 0f))) & 2147483647u))) * 0.5f);
let _e674 = ((bitcast<f32>((bitcast<u32>((_e495 + (_e573 * 0f))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((_e534 + (_e612 * 0f))) & 2147483647u))) * 0.5f);
let _e675 = (_e392 - _e672);
let _e676 = (_e404 - _e673);
let _e677 = (_e417 - _e674);
let _e678 = (_e392 + _e672);
let _e679 = (_e404 + _e673);
let _e680 = (_e417 + _e674);
let _e684 = select(_e675, _e331.member.x, (_e331.member.x < _e675));
let _e688 = select(_e676, _e331.member.y, (_e331.member.y < _e676));
let _e692 = select(_e677, _e331.member.z, (_e331.member.z < _e677));
let _e696 = select(_e678, _e331.member_1.x, (_e331.member_1.x > _e678));
let _e700 = select(_e679, _e331.member_1.y, (_e331.member_1.y > _e679));
let _e704 = select(_e680, _e331.member_1.z, (_e331.member_1.z > _e680));
let _e708 = (_e392 + (_e430 * _e625));
let _e709 = (_e404 + (_e443 * _e625));
let _e710 = (_e417 + (_e456 * _e625));
let _e744 = ((bitcast<f32>((bitcast<u32>((_e469 + (_e547 * _e625))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((_e508 + (_e586 * _e625))) & 2147483647u))) * 0.5f);
let _e745 = ((bitcast<f32>((bitcast<u32>((_e482 + (_e560 * _e625))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((_e521 + (_e599 * _e625))) & 2147483647u))) * 0.5f);
let _e746 = ((bitcast<f32>((bitcast<u32>((_e495 + (_e573 * _e625))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((_e534 + (_e612 * _e625))) & 2147483647u))) * 0.5f);
let _e747 = (_e708 - _e744);
let _e748 = (_e709 - _e745);
let _e749 = (_e710 - _e746);
let _e750 = (_e708 + _e744);
let _e751 = (_e709 + _e745);
let _e752 = (_e710 + _e746);
let _e816 = ((bitcast<f32>((bitcast<u32>(_e547) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e586) & 2147483647u))) * 0.5f);
let _e817 = ((bitcast<f32>((bitcast<u32>(_e560) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e599) & 2147483647u))) * 0.5f);
let _e818 = ((bitcast<f32>((bitcast<u32>(_e573) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e612) & 2147483647u))) * 0.5f);
let _e819 = (_e430 - _e816);
let _e820 = (_e443 - _e817);
let _e821 = (_e456 - _e818);
let _e822 = (_e430 + _e816);
let _e823 = (_e443 + _e817);
let _e824 = (_e456 + _e818);
if (_e638 < (0.5f * 1e30f)) {
let _e887 = ((bitcast<f32>((bitcast<u32>((_e469 + (_e547 * _e638))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((_e508 + (_e586 * _e638))) & 2147483647u))) * 0.5f);
let _e888 = ((bitcast<f32>((bitcast<u32>((_e482 + (_e560 * _e638))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((_e521 + (_e599 * _e638))) & 2147483647u))) * 0.5f);
let _e889 = ((bitcast<f32>((bitcast<u32>((_e495 + (_e573 * _e638))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((_e534 + (_e612 * _e638))) & 2147483647u))) * 0.5f);
let _e900 = ((_e887 + _e888) + _e889);
let _e907 = (_e392 + (_e430 * _e638));
let _e908 = (_e404 + (_e443 * _e638));
let _e909 = (_e417 + (_e456 * _e638));
let _e910 = (_e887 + (bitcast<f32>((bitcast<u32>(_e430) & 2147483647u)) * _e900));
let _e911 = (_e888 + (bitcast<f32>((bitcast<u32>(_e443) & 2147483647u)) * _e900));
let _e912 = (_e889 + (bitcast<f32>((bitcast<u32>(_e456) & 2147483647u)) * _e900));
let _e913 = (_e907 - _e910);
let _e914 = (_e908 - _e911);
let _e915 = (_e909 - _e912);
let _e916 = (_e907 + _e910);
let _e917 = (_e908 + _e911);
let _e918 = (_e909 + _e912);
phi_1509_ = type_24(vec3<f32>(select(_e913, _e325.member.x, (_e325.member.x < _e913)), select(_e914, _e325.member.y, (_e325.member.y < _e914)), select(_e915, _e325.member.z, (_e325.member.z < _e915))), vec3<f32>(select(_e916, _e325.member_1.x, (_e325.member_1.x > _e916)), select(_e917, _e325.member_1.y, (_e325.member_1.y > _e917)), select(_e918, _e325.member_1.z, (_e325.member_1.z > _e918))));
} else {
phi_1509_ = _e325;
}
let _e947 = phi_1509_;
phi_1510_ = _e947;
phi_1511_ = type_24(vec3<f32>(select(_e819, _e327.member.x, (_e327.member.x < _e819)), select(_e820, _e327.member.y, (_e327.member.y < _e820)), select(_e821, _e327.member.z, (_e327.member.z < _e821))), vec3<f32>(select(_e822, _e327.member_1.x, (_e327.member_1.x > _e822)), select(_e823, _e327.member_1.y, (_e327.member_1.y > _e823)), select(_e824, _e327.member_1.z, (_e327.member_1.z > _e824))));
phi_1512_ = type_24(vec3<f32>(select(_e675, _e329.member.x, (_e329.member.x < _e675)), select(_e676, _e329.member.y, (_e329.member.y < _e676)), select(_e677, _e329.member.z, (_e329.member.z < _e677))), vec3<f32>(select(_e678, _e329.member_1.x, (_e329.member_1.x > _e678)), select(_e679, _e329.member_1.y, (_e329.member_1.y > _e679)), select(_e680, _e329.member_1.z, (_e329.member_1.z > _e680))));
phi_1513_ = type_24(vec3<f32>(select(_e747, _e684, (_e684 < _e747)), select(_e748, _e688, (_e688 < _e748)), select(_e749, _e692, (_e692 < _e749))), vec3<f32>(select(_e750, _e696, (_e696 > _e750)), select(_e751, _e700, (_e700 > _e751)), select(_e752, _e704, (_e704 > _e752))));
} else {
phi_1510_ = _e325;
phi_1511_ = _e327;
phi_1512_ = _e329;
phi_1513_ = _e331;
}
let _e949 = phi_1510_;
let _e951 = phi_1511_;
let _e953 = phi_1512_;
let _e955 = phi_1513_;
phi_376_ = (_e323 + 1u);
phi_379_ = _e949;
phi_381_ = _e951;
phi_383_ = _e953;
phi_385_ = _e955;
} else {
phi_376_ = u32();
phi_379_ = type_24();
phi_381_ = type_24();
phi_383_ = type_24();
phi_385_ = type_24();
}
let _e958 = phi_376_;
let _e960 = phi_379_;
let _e962 = phi_381_;
let _e964 = phi_383_;
let _e966 = phi_385_;
continue;
continuing {
phi_375_ = _e958;
phi_378_ = _e960;
phi_380_ = _e962;
phi_382_ = _e964;
phi_384_ = _e966;
break if !(_e335);
}
}
phi_276_ = (_e231 + 1u);
let _e1198 = local_29;
phi_279_ = _e1198;
let _e1201 = local_30;
phi_281_ = _e1201;
let _e1204 = local_31;
phi_283_ = _e1204;
let _e1207 = local_32;
phi_285_ = _e1207;
} else {
phi_276_ = u32();
phi_279_ = type_24();
phi_281_ = type_24();
phi_283_ = type_24();
phi_285_ = type_24();
}
let _e970 = phi_276_;
let _e972 = phi_279_;
let _e974 = phi_281_;
let _e976 = phi_283_;
let _e978 = phi_285_;
continue;
continuing {
phi_275_ = _e970;
phi_278_ = _e972;
phi_280_ = _e974;
phi_282_ = _e976;
phi_284_ = _e978;
break if !(_e321);
}
}
let _e981 = local_21;
let _e984 = local_22;
let _e987 = local_23;
let _e990 = local_24;
let _e1011 = local_25;
let _e1014 = local_26;
let _e1035 = local_27;
let _e1038 = local_28;
global_2.member[_e85] = _e981.member.x;
global_2.member[(_e83 + _e85)] = _e981.member.y;
global_2.member[((2u * _e83) + _e85)] = _e981.member.z;
global_2.member[((3u * _e83) + _e85)] = _e984.member_1.x;
global_2.member[((4u * _e83) + _e85)] = _e984.member_1.y;
global_2.member[((5u * _e83) + _e85)] = _e984.member_1.z;
global_2.member[((6u * _e83) + _e85)] = ((_e987.member.x + _e990.member_1.x) * 0.5f);
global_2.member[((7u * _e83) + _e85)] = ((_e987.member.y + _e990.member_1.y) * 0.5f);
global_2.member[((8u * _e83) + _e85)] = ((_e987.member.z + _e990.member_1.z) * 0.5f);
global_2.member[((9u * _e83) + _e85)] = ((_e990.member_1.x - _e987.member.x) * 0.5f);
global_2.member[((10u * _e83) + _e85)] = ((_e990.member_1.y - _e987.member.y) * 0.5f);
global_2.member[((11u * _e83) + _e85)] = ((_e990.member_1.z - _e987.member.z) * 0.5f);
global_2.member[((12u * _e83) + _e85)] = ((_e1011.member.x + _e1014.member_1.x) * 0.5f);
global_2.member[((13u * _e83) + _e85)] = ((_e1011.member.y + _e1014.member_1.y) * 0.5f);
global_2.member[((14u * _e83) + _e85)] = ((_e1011.member.z + _e1014.member_1.z) * 0.5f);
global_2.member[((15u * _e83) + _e85)] = ((_e1014.member_1.x - _e1011.member.x) * 0.5f);
global_2.member[((16u * _e83) + _e85)] = ((_e1014.member_1.y - _e1011.member.y) * 0.5f);
global_2.member[((17u * _e83) + _e85)] = ((_e1014.member_1.z - _e1011.member.z) * 0.5f);
global_2.member[((18u * _e83) + _e85)] = _e1035.member.x;
global_2.member[((19u * _e83) + _e85)] = _e1035.member.y;
global_2.member[((20u * _e83) + _e85)] = _e1035.member.z;
global_2.member[((21u * _e83) + _e85)] = _e1038.member_1.x;
global_2.member[((22u * _e83) + _e85)] = _e1038.member_1.y;
global_2.member[((23u * _e83) + _e85)] = _e1038.member_1.z;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
