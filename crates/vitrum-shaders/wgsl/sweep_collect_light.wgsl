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
struct type_11 {
member: array<f32>,
}
struct type_14 {
member: u32,
member_1: u32,
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: vec3<f32>,
member_1: f32,
}
struct type_18 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_21 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_14,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_24 {
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
member_17: type_23,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: f32,
}
struct type_25 {
member: type_7,
member_1: u32,
}
struct type_26 {
member: type_2,
member_1: u32,
member_2: type_18,
member_3: type_14,
member_4: u32,
member_5: type_19,
member_6: type_20,
member_7: type_20,
member_8: type_21,
member_9: type_22,
member_10: type_24,
member_11: type_19,
member_12: type_4,
member_13: type_9,
member_14: type_25,
member_15: type_25,
member_16: type_25,
member_17: type_25,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_27 {
member: type_26,
}
var<private> global: vec3<u32>;
@group(0) @binding(4)
var<storage, read_write> global_1: type_11;
@group(0) @binding(0)
var<storage> global_2: type_27;
@group(0) @binding(2)
var<storage> global_3: type_11;
@group(0) @binding(1)
var<storage> global_4: type_16;
@group(0) @binding(3)
var<storage> global_5: type_16;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var phi_1636_: u32;
var phi_1637_: u32;
var phi_282_: u32;
var phi_283_: u32;
var phi_1384_: i32;
var phi_1554_: vec3<f32>;
var phi_1598_: i32;
var phi_1745_: type_17;
let _e56 = global;
let _e61 = arrayLength((&global_3.member));
let _e66 = global_2.member.member_2;
let _e69 = global_2.member.member;
let _e77 = (_e56.x + _e66.member);
let _e79 = (_e56.y + _e66.member_1);
if (_e77 < _e66.member_2) {
if (_e79 < _e66.member_3) {
let _e82 = (_e69.member * _e69.member_1);
let _e84 = ((_e79 * _e69.member) + _e77);
let _e89 = global_2.member.member.member;
let _e91 = ((_e79 * _e89) + _e77);
let _e92 = (_e91 / 81u);
let _e94 = (_e91 - (_e92 * 81u));
let _e95 = (_e94 / 9u);
let _e99 = global_2.member.member_10.member_16;
let _e101 = bitcast<i32>((_e99 + _e92));
let _e103 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e105 = select(_e103, _e101, (_e101 < _e103));
let _e111 = global_5.member[bitcast<u32>(select(0i, _e105, (_e105 > 0i)))];
let _e121 = ((bitcast<i32>((_e111 & 65535u)) * 8i) + bitcast<i32>((_e94 - (_e95 * 9u))));
let _e124 = ((bitcast<i32>((_e111 >> bitcast<u32>(16i))) * 8i) + bitcast<i32>(_e95));
let _e126 = (_e69.member_2 == 5u);
if ((((_e69.member_2 == 1u) || _e126) || (_e69.member_2 == 6u)) || ((_e69.member_2 == 2u) || (_e69.member_2 == 7u))) {
let _e233 = global_2.member.member_10.member_4.member;
let _e243 = global_2.member.member_10.member_4.member_1;
let _e246 = ((((_e121 >= 0i) && (_e121 < bitcast<i32>(_e233))) && (_e124 >= 0i)) && (_e124 < bitcast<i32>(_e243)));
if _e246 {
phi_282_ = bitcast<u32>(_e124);
phi_283_ = bitcast<u32>(_e121);
} else {
phi_282_ = 0u;
phi_283_ = 0u;
}
let _e250 = phi_282_;
let _e252 = phi_283_;
let _e253 = (_e233 + 1u);
let _e256 = bitcast<i32>((_e253 * (_e243 + 1u)));
local_6 = _e256;
let _e257 = (_e250 * _e253);
local_7 = bitcast<i32>((_e257 + _e252));
let _e260 = local_7;
let _e262 = (bitcast<i32>(_e61) - 1i);
let _e264 = select(_e262, _e260, (_e260 < _e262));
let _e269 = global_3.member[bitcast<u32>(select(0i, _e264, (_e264 > 0i)))];
let _e270 = local_6;
let _e271 = local_7;
let _e272 = (_e270 + _e271);
let _e274 = select(_e262, _e272, (_e272 < _e262));
let _e279 = global_3.member[bitcast<u32>(select(0i, _e274, (_e274 > 0i)))];
let _e280 = local_6;
let _e282 = local_7;
let _e283 = ((2i * _e280) + _e282);
let _e285 = select(_e262, _e283, (_e283 < _e262));
let _e290 = global_3.member[bitcast<u32>(select(0i, _e285, (_e285 > 0i)))];
let _e291 = local_6;
let _e293 = local_7;
let _e294 = ((3i * _e291) + _e293);
let _e296 = select(_e262, _e294, (_e294 < _e262));
let _e301 = global_3.member[bitcast<u32>(select(0i, _e296, (_e296 > 0i)))];
let _e302 = local_6;
let _e304 = local_7;
let _e305 = ((4i * _e302) + _e304);
let _e307 = select(_e262, _e305, (_e305 < _e262));
let _e312 = global_3.member[bitcast<u32>(select(0i, _e307, (_e307 > 0i)))];
let _e313 = local_6;
let _e315 = local_7;
let _e316 = ((5i * _e313) + _e315);
let _e318 = select(_e262, _e316, (_e316 < _e262));
let _e323 = global_3.member[bitcast<u32>(select(0i, _e318, (_e318 > 0i)))];
let _e324 = local_6;
let _e326 = local_7;
let _e327 = ((6i * _e324) + _e326);
let _e329 = select(_e262, _e327, (_e327 < _e262));
let _e334 = global_3.member[bitcast<u32>(select(0i, _e329, (_e329 > 0i)))];
let _e335 = local_6;
let _e337 = local_7;
let _e338 = ((7i * _e335) + _e337);
let _e340 = select(_e262, _e338, (_e338 < _e262));
let _e345 = global_3.member[bitcast<u32>(select(0i, _e340, (_e340 > 0i)))];
let _e346 = (_e252 + 1u);
local_4 = _e256;
local_5 = bitcast<i32>((_e257 + _e346));
let _e349 = local_5;
let _e351 = select(_e262, _e349, (_e349 < _e262));
let _e356 = global_3.member[bitcast<u32>(select(0i, _e351, (_e351 > 0i)))];
let _e357 = local_4;
let _e358 = local_5;
let _e359 = (_e357 + _e358);
let _e361 = select(_e262, _e359, (_e359 < _e262));
let _e366 = global_3.member[bitcast<u32>(select(0i, _e361, (_e361 > 0i)))];
let _e367 = local_4;
let _e369 = local_5;
let _e370 = ((2i * _e367) + _e369);
let _e372 = select(_e262, _e370, (_e370 < _e262));
let _e377 = global_3.member[bitcast<u32>(select(0i, _e372, (_e372 > 0i)))];
let _e378 = local_4;
let _e380 = local_5;
let _e381 = ((3i * _e378) + _e380);
let _e383 = select(_e262, _e381, (_e381 < _e262));
let _e388 = global_3.member[bitcast<u32>(select(0i, _e383, (_e383 > 0i)))];
let _e389 = local_4;
let _e391 = local_5;
let _e392 = ((4i * _e389) + _e391);
let _e394 = select(_e262, _e392, (_e392 < _e262));
let _e399 = global_3.member[bitcast<u32>(select(0i, _e394, (_e394 > 0i)))];
let _e400 = local_4;
let _e402 = local_5;
let _e403 = ((5i * _e400) + _e402);
let _e405 = select(_e262, _e403, (_e403 < _e262));
let _e410 = global_3.member[bitcast<u32>(select(0i, _e405, (_e405 > 0i)))];
let _e411 = local_4;
let _e413 = local_5;
let _e414 = ((6i * _e411) + _e413);
let _e416 = select(_e262, _e414, (_e414 < _e262));
let _e421 = global_3.member[bitcast<u32>(select(0i, _e416, (_e416 > 0i)))];
let _e422 = local_4;
let _e424 = local_5;
let _e425 = ((7i * _e422) + _e424);
let _e427 = select(_e262, _e425, (_e425 < _e262));
let _e432 = global_3.member[bitcast<u32>(select(0i, _e427, (_e427 > 0i)))];
local_2 = _e256;
let _e434 = ((_e250 + 1u) * _e253);
local_3 = bitcast<i32>((_e434 + _e252));
let _e437 = local_3;
let _e439 = select(_e262, _e437, (_e437 < _e262));
let _e444 = global_3.member[bitcast<u32>(select(0i, _e439, (_e439 > 0i)))];
let _e445 = local_2;
let _e446 = local_3;
let _e447 = (_e445 + _e446);
let _e449 = select(_e262, _e447, (_e447 < _e262));
let _e454 = global_3.member[bitcast<u32>(select(0i, _e449, (_e449 > 0i)))];
let _e455 = local_2;
let _e457 = local_3;
let _e458 = ((2i * _e455) + _e457);
let _e460 = select(_e262, _e458, (_e458 < _e262));
let _e465 = global_3.member[bitcast<u32>(select(0i, _e460, (_e460 > 0i)))];
let _e466 = local_2;
let _e468 = local_3;
let _e469 = ((3i * _e466) + _e468);
let _e471 = select(_e262, _e469, (_e469 < _e262));
let _e476 = global_3.member[bitcast<u32>(select(0i, _e471, (_e471 > 0i)))];
let _e477 = local_2;
let _e479 = local_3;
let _e480 = ((4i * _e477) + _e479);
let _e482 = select(_e262, _e480, (_e480 < _e262));
let _e487 = global_3.member[bitcast<u32>(select(0i, _e482, (_e482 > 0i)))];
let _e488 = local_2;
let _e490 = local_3;
let _e491 = ((5i * _e488) + _e490);
let _e493 = select(_e262, _e491, (_e491 < _e262));
let _e498 = global_3.member[bitcast<u32>(select(0i, _e493, (_e493 > 0i)))];
let _e499 = local_2;
let _e501 = local_3;
let _e502 = ((6i * _e499) + _e501);
let _e504 = select(_e262, _e502, (_e502 < _e262));
let _e509 = global_3.member[bitcast<u32>(select(0i, _e504, (_e504 > 0i)))];
let _e510 = local_2;
let _e512 = local_3;
let _e513 = ((7i * _e510) + _e512);
let _e515 = select(_e262, _e513, (_e513 < _e262));
let _e520 = global_3.member[bitcast<u32>(select(0i, _e515, (_e515 > 0i)))];
local = _e256;
local_1 = bitcast<i32>((_e434 + _e346));
let _e523 = local_1;
let _e525 = select(_e262, _e523, (_e523 < _e262));
let _e530 = global_3.member[bitcast<u32>(select(0i, _e525, (_e525 > 0i)))];
let _e531 = local;
let _e532 = local_1;
let _e533 = (_e531 + _e532);
let _e535 = select(_e262, _e533, (_e533 < _e262));
let _e540 = global_3.member[bitcast<u32>(select(0i, _e535, (_e535 > 0i)))];
let _e541 = local;
let _e543 = local_1;
let _e544 = ((2i * _e541) + _e543);
let _e546 = select(_e262, _e544, (_e544 < _e262));
let _e551 = global_3.member[bitcast<u32>(select(0i, _e546, (_e546 > 0i)))];
let _e552 = local;
let _e554 = local_1;
let _e555 = ((3i * _e552) + _e554);
let _e557 = select(_e262, _e555, (_e555 < _e262));
let _e562 = global_3.member[bitcast<u32>(select(0i, _e557, (_e557 > 0i)))];
let _e563 = local;
let _e565 = local_1;
let _e566 = ((4i * _e563) + _e565);
let _e568 = select(_e262, _e566, (_e566 < _e262));
let _e573 = global_3.member[bitcast<u32>(select(0i, _e568, (_e568 > 0i)))];
let _e574 = local;
let _e576 = local_1;
let _e577 = ((5i * _e574) + _e576);
let _e579 = select(_e262, _e577, (_e577 < _e262));
let _e584 = global_3.member[bitcast<u32>(select(0i, _e579, (_e579 > 0i)))];
let _e585 = local;
let _e587 = local_1;
let _e588 = ((6i * _e585) + _e587);
let _e590 = select(_e262, _e588, (_e588 < _e262));
let _e595 = global_3.member[bitcast<u32>(select(0i, _e590, (_e590 > 0i)))];
let _e596 = local;
let _e598 = local_1;
let _e599 = ((7i * _e596) + _e598);
let _e601 = select(_e262, _e599, (_e599 < _e262));
let _e606 = global_3.member[bitcast<u32>(select(0i, _e601, (_e601 > 0i)))];
let _e621 = (0.5f * bitcast<f32>((bitcast<u32>((((_e530 - _e269) * (_e454 - _e366)) - ((_e540 - _e279) * (_e444 - _e356)))) & 2147483647u)));
let _e627 = (f32(bitcast<i32>(_e252)) - 0.5f);
let _e630 = (f32(bitcast<i32>(_e250)) - 0.5f);
let _e644 = (_e627 + 1f);
let _e659 = (_e630 + 1f);
let _e691 = select(0f, (0.25f / select(select(0.25f, _e621, (_e621 > 0.25f)), 1f, (((_e345 + _e432) + (_e520 + _e606)) == 0f))), (((((((bitcast<f32>((bitcast<u32>((_e269 - _e627)) & 2147483647u)) < 0.5f) && (bitcast<f32>((bitcast<u32>((_e279 - _e630)) & 2147483647u)) < 0.5f)) && (_e345 != 2f)) && (((bitcast<f32>((bitcast<u32>((_e356 - _e644)) & 2147483647u)) < 0.5f) && (bitcast<f32>((bitcast<u32>((_e366 - _e630)) & 2147483647u)) < 0.5f)) && (_e432 != 2f))) && (((bitcast<f32>((bitcast<u32>((_e444 - _e627)) & 2147483647u)) < 0.5f) && (bitcast<f32>((bitcast<u32>((_e454 - _e659)) & 2147483647u)) < 0.5f)) && (_e520 != 2f))) && (((bitcast<f32>((bitcast<u32>((_e530 - _e644)) & 2147483647u)) < 0.5f) && (bitcast<f32>((bitcast<u32>((_e540 - _e659)) & 2147483647u)) < 0.5f)) && (_e606 != 2f))) && (_e621 >= 0.5f)));
let _e692 = select(0f, _e691, _e246);
let _e705 = select(1f, (((_e290 + _e377) + (_e465 + _e551)) * _e691), _e246);
let _e706 = select(1f, (((_e301 + _e388) + (_e476 + _e562)) * _e691), _e246);
let _e707 = select(1f, (((_e312 + _e399) + (_e487 + _e573)) * _e691), _e246);
let _e711 = (1f / 3f);
let _e712 = (((_e290 + _e301) + _e312) * _e711);
let _e717 = (((_e377 + _e388) + _e399) * _e711);
let _e724 = (((_e465 + _e476) + _e487) * _e711);
let _e729 = (((_e551 + _e562) + _e573) * _e711);
let _e741 = global_2.member.member_10.member_15;
let _e742 = bitcast<i32>(_e741);
let _e744 = (firstTrailingBit(8u) & 31u);
let _e746 = (_e121 >> bitcast<u32>(_e744));
let _e748 = (_e124 >> bitcast<u32>(_e744));
let _e753 = global_2.member.member_10.member_14.member;
let _e754 = bitcast<i32>(_e753);
let _e759 = global_2.member.member_10.member_14.member_1;
let _e760 = bitcast<i32>(_e759);
let _e765 = global_2.member.member_10.member_14.member_2;
if ((((((_e746 >= 0i) && (_e746 < _e754)) && (_e748 >= 0i)) && (_e748 < _e760)) && (_e742 >= 0i)) && (_e742 < bitcast<i32>(_e765))) {
phi_1384_ = (((((_e742 * _e760) + _e748) * _e754) + _e746) * 3i);
} else {
phi_1384_ = -1i;
}
let _e784 = phi_1384_;
let _e785 = (_e784 + 2i);
let _e787 = select(_e103, _e785, (_e785 < _e103));
let _e793 = global_5.member[bitcast<u32>(select(0i, _e787, (_e787 > 0i)))];
let _e794 = bitcast<i32>(_e793);
let _e805 = select(((((_e794 - 1i) * 64i) + ((_e124 & 7i) * 8i)) + (_e121 & 7i)), -1i, ((_e784 < 0i) || (_e794 == 0i)));
let _e806 = (_e805 * 6i);
let _e812 = global_2.member.member_10.member_20;
let _e813 = (select(0f, 1f, (_e805 >= 0i)) / _e812);
let _e815 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e817 = select(_e815, _e806, (_e806 < _e815));
let _e823 = global_4.member[bitcast<u32>(select(0i, _e817, (_e817 > 0i)))];
let _e824 = bitcast<i32>(_e823);
let _e825 = (_e806 + 1i);
let _e827 = select(_e815, _e825, (_e825 < _e815));
let _e833 = global_4.member[bitcast<u32>(select(0i, _e827, (_e827 > 0i)))];
let _e838 = f32(_e824);
let _e840 = (_e806 + 2i);
let _e842 = select(_e815, _e840, (_e840 < _e815));
let _e848 = global_4.member[bitcast<u32>(select(0i, _e842, (_e842 > 0i)))];
let _e849 = bitcast<i32>(_e848);
let _e850 = (_e806 + 3i);
let _e852 = select(_e815, _e850, (_e850 < _e815));
let _e858 = global_4.member[bitcast<u32>(select(0i, _e852, (_e852 > 0i)))];
if (((_e69.member_2 == 3u) || (_e69.member_2 == 4u)) || _e126) {
phi_1554_ = vec3(_e838);
} else {
let _e869 = (_e806 + 4i);
let _e871 = select(_e815, _e869, (_e869 < _e815));
let _e877 = global_4.member[bitcast<u32>(select(0i, _e871, (_e871 > 0i)))];
phi_1554_ = vec3<f32>(_e838, f32((bitcast<i32>(_e833) - (_e824 >> bitcast<u32>(31i)))), f32(bitcast<i32>(_e877)));
}
let _e883 = phi_1554_;
let _e885 = (_e883.x * _e813);
let _e887 = (_e883.y * _e813);
let _e889 = (_e883.z * _e813);
let _e897 = ((((_e705 + _e885) + (_e706 + _e887)) + (_e707 + _e889)) * _e711);
let _e898 = (_e897 > 1e-4f);
let _e901 = select(0f, (1f / select(1e-4f, _e897, _e898)), _e898);
let _e904 = ((((((_e323 * _e712) + (_e410 * _e717)) + ((_e498 * _e724) + (_e584 * _e729))) * _e692) + (f32(_e849) * _e813)) * _e901);
let _e907 = ((((((_e334 * _e712) + (_e421 * _e717)) + ((_e509 * _e724) + (_e595 * _e729))) * _e692) + (f32((bitcast<i32>(_e858) - (_e849 >> bitcast<u32>(31i)))) * _e813)) * _e901);
if (_e904 < 0f) {
let _e935 = ((bitcast<f32>((bitcast<u32>(_e904) & 2147483647u)) * 16255f) + 0.5f);
let _e936 = (2f * 16255f);
let _e938 = select(0f, _e935, (_e935 > 0f));
let _e940 = select(_e936, _e938, (_e938 < _e936));
let _e947 = select(0i, select(select(i32(_e940), i32(-2147483648), (_e940 < -2147483600f)), 2147483647i, (_e940 > 2147483500f)), (_e940 == _e940));
phi_1598_ = (32768i - (_e947 - select(0i, 1i, (_e940 < f32(_e947)))));
} else {
let _e913 = ((bitcast<f32>((bitcast<u32>(_e904) & 2147483647u)) * 16255f) + 0.5f);
let _e914 = (2f * 16255f);
let _e916 = select(0f, _e913, (_e913 > 0f));
let _e918 = select(_e914, _e916, (_e916 < _e914));
let _e925 = select(0i, select(select(i32(_e918), i32(-2147483648), (_e918 < -2147483600f)), 2147483647i, (_e918 > 2147483500f)), (_e918 == _e918));
phi_1598_ = (32768i + (_e925 - select(0i, 1i, (_e918 < f32(_e925)))));
}
let _e954 = phi_1598_;
let _e961 = ((bitcast<f32>((bitcast<u32>(_e907) & 2147483647u)) * 16255f) + 0.5f);
let _e962 = (2f * 16255f);
let _e964 = select(0f, _e961, (_e961 > 0f));
let _e966 = select(_e962, _e964, (_e964 < _e962));
let _e973 = select(0i, select(select(i32(_e966), i32(-2147483648), (_e966 < -2147483600f)), 2147483647i, (_e966 > 2147483500f)), (_e966 == _e966));
phi_1745_ = type_17((vec3<f32>(_e705, _e706, _e707) + vec3<f32>(_e885, _e887, _e889)), bitcast<f32>(((select(0u, 2147483648u, (_e907 < 0f)) | (bitcast<u32>(((_e973 - select(0i, 1i, (_e966 < f32(_e973)))) + 128i)) << bitcast<u32>(16i))) | bitcast<u32>(_e954))));
} else {
let _e139 = global_2.member.member_10.member_4.member;
let _e149 = global_2.member.member_10.member_4.member_1;
let _e152 = ((((_e121 >= 0i) && (_e121 <= bitcast<i32>(_e139))) && (_e124 >= 0i)) && (_e124 <= bitcast<i32>(_e149)));
if _e152 {
phi_1636_ = bitcast<u32>(_e124);
phi_1637_ = bitcast<u32>(_e121);
} else {
phi_1636_ = 0u;
phi_1637_ = 0u;
}
let _e156 = phi_1636_;
let _e158 = phi_1637_;
let _e159 = (_e139 + 1u);
let _e162 = bitcast<i32>((_e159 * (_e149 + 1u)));
let _e167 = ((6i * _e162) + bitcast<i32>(((_e156 * _e159) + _e158)));
let _e169 = (bitcast<i32>(_e61) - 1i);
let _e171 = select(_e169, _e167, (_e167 < _e169));
let _e177 = global_3.member[bitcast<u32>(select(0i, _e171, (_e171 > 0i)))];
let _e178 = (_e167 + _e162);
let _e180 = select(_e169, _e178, (_e178 < _e169));
let _e186 = global_3.member[bitcast<u32>(select(0i, _e180, (_e180 > 0i)))];
let _e188 = (_e167 + (2i * _e162));
let _e190 = select(_e169, _e188, (_e188 < _e169));
let _e196 = global_3.member[bitcast<u32>(select(0i, _e190, (_e190 > 0i)))];
let _e202 = ((0f * 16255f) + 0.5f);
let _e203 = (2f * 16255f);
let _e205 = select(0f, _e202, (_e202 > 0f));
let _e207 = select(_e203, _e205, (_e205 < _e203));
let _e214 = select(0i, select(select(i32(_e207), i32(-2147483648), (_e207 < -2147483600f)), 2147483647i, (_e207 > 2147483500f)), (_e207 == _e207));
let _e218 = (_e214 - select(0i, 1i, (_e207 < f32(_e214))));
phi_1745_ = type_17(vec3<f32>(select(1f, _e177, _e152), select(1f, _e186, _e152), select(1f, _e196, _e152)), bitcast<f32>(((bitcast<u32>((_e218 + 128i)) << bitcast<u32>(16i)) | bitcast<u32>((32768i + _e218)))));
}
let _e988 = phi_1745_;
global_1.member[_e84] = _e988.member.x;
global_1.member[(_e82 + _e84)] = _e988.member.y;
global_1.member[((2u * _e82) + _e84)] = _e988.member.z;
global_1.member[((3u * _e82) + _e84)] = _e988.member_1;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
